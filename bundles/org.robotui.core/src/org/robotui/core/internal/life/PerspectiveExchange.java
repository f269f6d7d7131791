package org.robotui.core.internal.life;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.UicType;
import org.robotui.api.UicType.Surface;
import org.robotui.api.config.Setting;
import org.robotui.api.host.Arranging.PerspectiveImport;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Arrangement.Added;
import org.robotui.api.layout.Arrangement.OwnWindow;
import org.robotui.api.layout.Layout;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.PerspectiveFile;
import org.robotui.core.internal.config.model.PerspectiveFile.View;

/**
 * Gives perspectives to others and takes them. Nothing that this RUIC has is overwritten: a view that the file has with
 * other settings comes as one more view.
 *
 * @param ruic the RUIC
 * @param plan its views
 * @param views where perspectives are kept
 */
record PerspectiveExchange(RuicParts ruic, ArrangedPlan plan, ArrangedViews views) {
  /** A perspective for others. */
  String text(String name, Arrangement arrangement) {
    Map<String, View> described = new LinkedHashMap<>();
    plan.running(arrangement, view -> true)
        .forEach(view -> described.put(view.id(), new View(view.type(), settings(view))));
    return ruic.overlay().format().text(new PerspectiveFile(name, arrangement, described));
  }

  /** What was chosen before what is written. Where a view was left is its user's alone. */
  private Map<String, Object> settings(ComponentConfig view) {
    Map<String, Object> settings = new HashMap<>(ruic.services().check().values(view.raw()));
    settings.putAll(ruic.overlay().settings(view.id()));
    ruic.services().registry().uic(view.type()).stream().flatMap(type -> type.schema().settings().stream())
        .filter(Setting::state).forEach(setting -> settings.remove(setting.name()));
    return settings;
  }

  /** Keeps a perspective that comes from elsewhere. */
  PerspectiveImport take(String text) {
    PerspectiveFile file;
    try {
      file = ruic.overlay().format().perspective(text);
    } catch (IOException e) {
      return new PerspectiveImport.Refused(e.getMessage());
    }
    List<String> missing = new ArrayList<>();
    List<Added> added = new ArrayList<>();
    Map<String, String> here = new HashMap<>();
    for (String id : file.arrangement().views()) {
      View view = file.views().getOrDefault(id, new View(id, Map.of()));
      place(id, view, added).ifPresentOrElse(own -> here.put(id, own),
          () -> missing.add("'" + id + "': no view of type '" + view.type() + "' is installed"));
    }
    Arrangement known = file.arrangement().only(here.keySet());
    String name = freshName(file.name().isBlank() ? "Imported" : file.name());
    views.keep(name, new Arrangement(renamed(known.layout(), here),
        known.windows().stream().map(w -> new OwnWindow(renamed(w.layout(), here), w.bounds())).toList(), added),
        false);
    return new PerspectiveImport.Kept(name, missing);
  }

  /** The view here that stands for one of the file. */
  private Optional<String> place(String id, View view, List<Added> added) {
    Optional<String> same = plan.planned().stream()
        .filter(p -> p.id().equals(id) && p.type().equals(view.type()))
        .filter(p -> view.settings().isEmpty() || settings(p).equals(view.settings())).map(ComponentConfig::id)
        .findFirst();
    return same.or(() -> ruic.services().registry().uic(view.type())
        .filter(type -> type.surface() == Surface.WINDOW).map(type -> add(id, type, view, added)));
  }

  private String add(String id, UicType type, View view, List<Added> added) {
    Set<String> taken = new LinkedHashSet<>(plan.ids(added));
    taken.addAll(plan.ids(views.now().added()));
    views.perspectives().values().forEach(p -> p.arrangement().added().forEach(a -> taken.add(a.id())));
    String fresh = FreshName.of(id, type.id() + "-", candidate -> !taken.contains(candidate));
    added.add(new Added(fresh, type.id()));
    view.settings().forEach((name, value) -> ruic.overlay().set(fresh, name, value));
    return fresh;
  }

  private String freshName(String wanted) {
    Set<String> taken = views.perspectives().keySet();
    return FreshName.of(wanted, wanted + " ", name -> !taken.contains(name));
  }

  private static Layout renamed(Layout layout, Map<String, String> names) {
    return switch (layout) {
      case Layout.View view -> new Layout.View(names.get(view.uic()));
      case Layout.Tabs tabs -> new Layout.Tabs(tabs.uics().stream().map(names::get).toList(),
          tabs.front());
      case Layout.Split split -> new Layout.Split(split.direction(),
          split.parts().stream().map(part -> renamed(part, names)).toList(), split.weights());
    };
  }
}
