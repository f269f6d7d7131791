package org.robotui.core.internal.config;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Arrangement.Added;
import org.robotui.api.layout.Arrangement.OwnWindow;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.Layout.Direction;
import org.robotui.api.layout.WindowBounds;

/**
 * Arrangements as values of YAML, with the words that configurations have for layouts. What is read was checked for its
 * depth before; it may be damaged, and is refused then by an {@link IllegalArgumentException}.
 */
final class ArrangementYaml {
  private static final int MOST_VIEWS = 1000;

  private ArrangementYaml() {}

  static Map<String, Object> written(Arrangement arrangement) {
    Map<String, Object> written = new LinkedHashMap<>();
    written.put("layout", written(arrangement.layout()));
    if (!arrangement.windows().isEmpty()) {
      written.put("windows", arrangement.windows().stream().map(ArrangementYaml::written).toList());
    }
    if (!arrangement.added().isEmpty()) {
      Map<String, Object> added = new LinkedHashMap<>();
      arrangement.added().forEach(view -> added.put(view.id(), view.type()));
      written.put("added", added);
    }
    return written;
  }

  private static Map<String, Object> written(OwnWindow window) {
    WindowBounds at = window.bounds();
    Map<String, Object> written = new LinkedHashMap<>();
    written.put("at", List.of(at.x(), at.y(), at.width(), at.height()));
    written.put("layout", written(window.layout()));
    return written;
  }

  private static Map<String, Object> written(Layout layout) {
    Map<String, Object> written = new LinkedHashMap<>();
    switch (layout) {
      case Layout.View view -> written.put("view", view.uic());
      case Layout.Tabs tabs -> {
        written.put("tabs", new ArrayList<>(tabs.uics())); // a list of its own: YAML would name one that comes again
        if (tabs.front() > 0) {
          written.put("front", tabs.uics().get(tabs.front()));
        }
      }
      case Layout.Split split -> written.put(split.direction().name().toLowerCase(Locale.ROOT), parts(split));
    }
    return written;
  }

  private static List<Object> parts(Layout.Split split) {
    List<Object> parts = new ArrayList<>();
    for (int i = 0; i < split.parts().size(); i++) {
      Map<String, Object> part = new LinkedHashMap<>();
      part.put("weight", split.weights().get(i));
      part.putAll(written(split.parts().get(i)));
      parts.add(part);
    }
    return parts;
  }

  static Arrangement read(Map<String, Object> value) {
    List<OwnWindow> windows = KeptYaml.list(value.get("windows")).stream().map(w -> window(KeptYaml.map(w))).toList();
    List<Added> added = KeptYaml.map(value.get("added")).entrySet().stream()
        .map(e -> new Added(e.getKey(), e.getValue().toString())).toList();
    Arrangement read = new Arrangement(layout(KeptYaml.map(value.get("layout"))), windows, added);
    if (read.views().size() > MOST_VIEWS || added.size() > MOST_VIEWS) {
      throw new IllegalArgumentException("it has more than " + MOST_VIEWS + " views");
    }
    return read;
  }

  private static OwnWindow window(Map<String, Object> value) {
    List<Integer> at = KeptYaml.list(value.get("at")).stream().map(ArrangementYaml::points).toList();
    Layout layout = layout(KeptYaml.map(value.get("layout")));
    if (at.size() != 4 || layout.views().isEmpty()) {
      throw new IllegalArgumentException("a window has 'at: [x, y, width, height]' and at least one view");
    }
    return new OwnWindow(layout, new WindowBounds(at.get(0), at.get(1), at.get(2), at.get(3)));
  }

  private static int points(Object value) {
    return value instanceof Number n ? Math.clamp(n.longValue(), -1_000_000, 1_000_000)
        : KeptYaml.refuse("a number of points", value);
  }

  private static Layout layout(Map<String, Object> value) {
    if (value.containsKey("view")) {
      return new Layout.View(value.get("view").toString());
    }
    for (Direction direction : Direction.values()) {
      Object parts = value.get(direction.name().toLowerCase(Locale.ROOT));
      if (parts != null) {
        return split(direction, KeptYaml.list(parts));
      }
    }
    List<String> tabs = KeptYaml.list(value.get("tabs")).stream().map(Object::toString).toList();
    return new Layout.Tabs(tabs, Math.max(0, tabs.indexOf(String.valueOf(value.get("front")))));
  }

  private static Layout split(Direction direction, List<Object> items) {
    List<Layout> parts = new ArrayList<>();
    List<Double> weights = new ArrayList<>();
    for (Object item : items) {
      Map<String, Object> part = KeptYaml.map(item);
      parts.add(layout(part));
      weights.add(part.get("weight") instanceof Number n && n.doubleValue() > 0 && n.doubleValue() < 1e9
          ? n.doubleValue()
          : 1.0);
    }
    return new Layout.Split(direction, parts, weights);
  }
}
