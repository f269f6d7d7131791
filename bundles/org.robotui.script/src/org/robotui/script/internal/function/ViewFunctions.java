package org.robotui.script.internal.function;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.host.Arranging;
import org.robotui.api.host.Arranging.ViewChoice;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.ViewFit;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Arrangement.Added;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;

/** Views and perspectives of a robot UI. */
final class ViewFunctions {
  private ViewFunctions() {}

  static List<ScriptFunction> functions() {
    return List.of(
        ScriptFunction.of("views(ui?)", "Lists the views that are open or could be opened again.",
            "a list of {id, type, title, open}",
            call -> Named.ruic(call, 0).arranging().views().stream().map(ViewFunctions::described).toList()),
        ScriptFunction.of("viewTypes(ui?)", "Lists the types of views, those that fit the robots first.",
            "a list of {type, label, fit, reason}",
            call -> Named.ruic(call, 0).arranging().types().stream().map(ViewFunctions::described).toList()),
        ScriptFunction.of("openView(view, ui?)", "Opens a view by its id, or one more of a type.", "the id of the view",
            ViewFunctions::open),
        ScriptFunction.of("closeView(view, ui?)", "Closes a view.", "", ViewFunctions::close),
        ScriptFunction.of("showView(view, ui?)", "Brings a view to the front of its tabs.", "", call -> {
          Arranging views = Named.ruic(call, 1).arranging();
          views.arrange(views.now().fronted(opened(call, views)));
          return null;
        }),
        ScriptFunction.of("settings(view, ui?)", "Tells the settings of a view that runs.", "their values by name",
            call -> inOrder(settings(call, Named.ruic(call, 1)).current())),
        ScriptFunction.of("setSetting(view, setting, value, ui?)",
            "Changes a setting of a view, at once and for the next start, too.", "", ViewFunctions::set),
        ScriptFunction.of("perspectives(ui?)", "Lists the perspectives.", "a list of names",
            call -> List.copyOf(Named.ruic(call, 0).arranging().perspectives().keySet())),
        ScriptFunction.of("perspective(name, ui?)", "Arranges the views as a perspective has them.", "", call -> {
          arranging(call).choose(call.text(0));
          return null;
        }),
        ScriptFunction.of("keepPerspective(name, ui?)", "Keeps how the views lie now as a perspective.", "",
            ViewFunctions::keep),
        ScriptFunction.of("forgetPerspective(name, ui?)", "Forgets a perspective that was kept.", "", call -> {
          arranging(call).forget(call.text(0));
          return null;
        }),
        ScriptFunction.of("resetLayout(ui?)", "Arranges the views as the configuration has them.", "", call -> {
          Named.ruic(call, 0).arranging().reset();
          return null;
        }));
  }

  private static Map<String, Object> described(ViewChoice view) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("id", view.id());
    all.put("type", view.type());
    all.put("title", view.title());
    all.put("open", view.open());
    return all;
  }

  private static Map<String, Object> described(ViewFit type) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("type", type.type());
    all.put("label", type.label());
    all.put("fit", Named.word(type.fit()));
    all.put("reason", type.reason());
    return all;
  }

  private static Object open(ScriptCall call) throws ScriptFailure {
    String wanted = call.text(0);
    Ruic ruic = Named.ruic(call, 1);
    Arranging views = ruic.arranging();
    Arrangement now = views.now();
    Optional<ViewChoice> there = views.views().stream().filter(v -> v.id().equals(wanted)).findFirst();
    if (there.isPresent()) {
      views.arrange(there.get().open() ? now.fronted(wanted) : now.opened(wanted, views.written().layout()));
      return wanted;
    }
    if (views.types().stream().noneMatch(t -> t.type().equals(wanted))) {
      throw new ScriptFailure(
          ruic.name() + " has no view '" + wanted + "', nor is there such a type; see views() and viewTypes()");
    }
    String id = views.freshId(wanted);
    views.arrange(now.adding(new Added(id, wanted)).opened(id, views.written().layout()));
    return id;
  }

  /** As they are listed everywhere: a map of settings has no order. */
  private static Map<String, Object> inOrder(Settings settings) {
    Map<String, Object> all = new LinkedHashMap<>();
    settings.schema().settings().stream().map(Setting::name).filter(settings.values()::containsKey)
        .forEach(name -> all.put(name, settings.values().get(name)));
    return all;
  }

  private static SettingsStore settings(ScriptCall call, Ruic ruic) throws ScriptFailure {
    String view = call.text(0);
    return ruic.settings(view).orElseThrow(
        () -> new ScriptFailure(ruic.name() + " has no view '" + view + "' that runs; see views()"));
  }

  private static Object set(ScriptCall call) throws ScriptFailure {
    SettingsStore store = settings(call, Named.ruic(call, 3));
    String name = call.text(1);
    if (store.current().schema().find(name).isEmpty()) {
      throw new ScriptFailure("there is no setting '" + name + "'; there are: "
          + store.current().schema().settings().stream().map(Setting::name).collect(Collectors.joining(", ")));
    }
    Object value = call.argument(2)
        .orElseThrow(() -> new ScriptFailure("setSetting takes a view, a setting and its value"));
    try {
      store.set(name, written(value));
    } catch (IllegalArgumentException e) {
      throw new ScriptFailure(e.getMessage());
    }
    return null;
  }

  /** As a configuration has it: scripts have no whole numbers of their own. */
  private static Object written(Object value) {
    return switch (value) {
      case Double number when number == Math.rint(number) && Math.abs(number) < 1e15 -> number.longValue();
      case List<?> items -> items.stream().map(ViewFunctions::written).toList();
      case Map<?, ?> members -> {
        Map<Object, Object> all = new LinkedHashMap<>();
        members.forEach((key, member) -> all.put(key, written(member)));
        yield all;
      }
      default -> value;
    };
  }

  private static Object close(ScriptCall call) throws ScriptFailure {
    Arranging views = Named.ruic(call, 1).arranging();
    views.arrange(views.now().closed(opened(call, views)));
    return null;
  }

  private static String opened(ScriptCall call, Arranging views) throws ScriptFailure {
    String id = call.text(0);
    if (!views.now().views().contains(id)) {
      throw new ScriptFailure("no view '" + id + "' is open; open are: " + String.join(", ", views.now().views()));
    }
    return id;
  }

  private static Object keep(ScriptCall call) throws ScriptFailure {
    try {
      Named.ruic(call, 1).arranging().keep(call.text(0));
    } catch (IllegalArgumentException e) {
      throw new ScriptFailure(e.getMessage());
    }
    return null;
  }

  private static Arranging arranging(ScriptCall call) throws ScriptFailure {
    Arranging views = Named.ruic(call, 1).arranging();
    if (!views.perspectives().containsKey(call.text(0))) {
      throw new ScriptFailure("there is no perspective '" + call.text(0) + "'; there are: "
          + String.join(", ", views.perspectives().keySet()));
    }
    return views;
  }
}
