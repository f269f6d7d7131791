package org.robotui.core.internal.config;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.robotui.api.layout.Arrangement;
import org.robotui.core.internal.config.model.KeptViews;
import org.robotui.core.internal.config.model.KeptViews.Hand;
import org.robotui.core.internal.config.model.PerspectiveFile;
import org.robotui.core.internal.config.model.PerspectiveFile.View;

/** How users arranged views, as values of YAML. */
final class KeptViewsYaml {
  private static final String MARK = "robotui_perspective";
  private static final int VERSION = 1;

  private KeptViewsYaml() {}

  static Map<String, Object> written(KeptViews views) {
    Map<String, Object> written = new LinkedHashMap<>();
    views.arrangement().ifPresent(hand -> {
      Map<String, Object> section = ArrangementYaml.written(hand.arrangement());
      section.put("known", new ArrayList<>(hand.known()));
      section.put("instead_of", hand.insteadOf());
      written.put("arrangement", section);
    });
    if (!views.perspectives().isEmpty()) {
      Map<String, Object> named = new TreeMap<>();
      views.perspectives().forEach((name, arrangement) -> named.put(name, ArrangementYaml.written(arrangement)));
      written.put("perspectives", named);
    }
    views.perspective().ifPresent(name -> written.put("perspective", name));
    return written;
  }

  static KeptViews read(Object value) {
    Map<String, Object> section = KeptYaml.map(value);
    Map<String, Arrangement> named = new LinkedHashMap<>();
    KeptYaml.map(section.get("perspectives"))
        .forEach((name, arrangement) -> named.put(name, ArrangementYaml.read(KeptYaml.map(arrangement))));
    return new KeptViews(Optional.ofNullable(section.get("arrangement")).map(v -> hand(KeptYaml.map(v))), named,
        Optional.ofNullable(section.get("perspective")).map(Object::toString));
  }

  private static Hand hand(Map<String, Object> section) {
    Set<String> known = KeptYaml.list(section.get("known")).stream().map(Object::toString)
        .collect(Collectors.toCollection(LinkedHashSet::new));
    return new Hand(ArrangementYaml.read(section), known, String.valueOf(section.getOrDefault("instead_of", "")));
  }

  /** A perspective for others; its first line says what the file is. */
  static Map<String, Object> written(PerspectiveFile file) {
    Map<String, Object> written = new LinkedHashMap<>();
    written.put(MARK, VERSION);
    written.put("name", file.name());
    Map<String, Object> views = new TreeMap<>();
    file.views().forEach((id, view) -> {
      Map<String, Object> words = new LinkedHashMap<>(Map.of("type", view.type()));
      if (!view.settings().isEmpty()) {
        words.put("settings", new TreeMap<>(view.settings()));
      }
      views.put(id, words);
    });
    written.put("views", views);
    written.putAll(ArrangementYaml.written(file.arrangement()));
    return written;
  }

  /** Throws an IllegalArgumentException with a sentence where it is no perspective. */
  static PerspectiveFile perspective(Object value) {
    Map<String, Object> section = value instanceof Map<?, ?> ? KeptYaml.map(value) : Map.of();
    if (!(section.get(MARK) instanceof Integer version)) {
      throw new IllegalArgumentException("it is not a perspective: its first line is not '" + MARK + ": 1'");
    }
    if (version > VERSION) {
      throw new IllegalArgumentException("a later RobotUI has written it; this one reads version " + VERSION);
    }
    Map<String, View> views = new LinkedHashMap<>();
    KeptYaml.map(section.get("views")).forEach((id, words) -> {
      Map<String, Object> view = KeptYaml.map(words);
      views.put(id, new View(view.getOrDefault("type", id).toString(), KeptYaml.settings(view.get("settings"))));
    });
    Arrangement arrangement = ArrangementYaml.read(section);
    return new PerspectiveFile(section.getOrDefault("name", "").toString(),
        new Arrangement(arrangement.layout(), arrangement.windows(), List.of()), views);
  }
}
