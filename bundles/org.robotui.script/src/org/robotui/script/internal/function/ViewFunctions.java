package org.robotui.script.internal.function;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
