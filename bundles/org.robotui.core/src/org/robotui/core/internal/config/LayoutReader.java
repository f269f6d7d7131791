package org.robotui.core.internal.config;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.host.Problem;
import org.robotui.api.layout.Layout;

/**
 * Reads a layout: the id of a view, {@code tabs: [ids]}, perhaps with the one that is in {@code front:}, or
 * {@code row:} or {@code column:} with a list of layouts, each with an optional {@code weight}. A view with a weight is
 * {@code {view: id, weight: 2}}.
 */
final class LayoutReader {
  private static final List<String> KINDS = List.of("view", "tabs", "row", "column");
  private static final List<String> KEYS = List.of("view", "tabs", "front", "row", "column", "weight");

  private final Known views;
  private final List<Problem> problems;

  LayoutReader(Known views, List<Problem> problems) {
    this.views = views;
    this.problems = problems;
  }

  /** Reads a layout in which no view has two places. */
  Optional<Layout> readWhole(YamlValue value) {
    Optional<Layout> layout = read(value);
    List<String> views = layout.map(Layout::views).orElse(List.of());
    Set<String> once = new HashSet<>();
    List<String> twice = views.stream().filter(id -> !once.add(id)).distinct().toList();
    twice.forEach(id -> problems.add(value.place().error("the view '" + id
        + "' has two places in the layout; for a second view of its type write one with an id of its own under uics:")));
    return layout.filter(l -> twice.isEmpty());
  }

  private Optional<Layout> read(YamlValue value) {
    return switch (value) {
      case YamlValue.Scalar s -> view(s);
      case YamlValue.Section s -> section(s);
      case YamlValue.Items i -> {
        problems.add(i.place().error("a layout must be a view, tabs:, row: or column:, not a list"));
        yield Optional.empty();
      }
    };
  }

  private Optional<Layout> view(YamlValue value) {
    return viewId(value).map(Layout.View::new);
  }

  private Optional<String> viewId(YamlValue value) {
    Optional<String> id = Shape.text(value, "a view", problems);
    id.filter(i -> !views.mayHave(i)).ifPresent(
        i -> problems.add(value.place().error("there is no view '" + i + "'" + NearestWord.hint(i, views.ids()))));
    return id.filter(views::mayHave);
  }

  private Optional<Layout> section(YamlValue.Section section) {
    Shape.onlyKeys(section, KEYS, "in a layout", problems);
    section.get("weight").ifPresent(w -> Shape.weight(w, problems));
    List<YamlValue.Entry> kinds = section.entries().stream().filter(e -> KINDS.contains(e.key())).toList();
    if (kinds.size() != 1) {
      problems.add(section.place().error("a layout has exactly one of view:, tabs:, row: and column:"));
      return Optional.empty();
    }
    YamlValue.Entry kind = kinds.getFirst();
    return switch (kind.key()) {
      case "view" -> view(kind.value());
      case "tabs" -> tabs(kind.value(), section.get("front"));
      case "row" -> split(Layout.Direction.ROW, kind.value());
      default -> split(Layout.Direction.COLUMN, kind.value());
    };
  }

  private Optional<Layout> tabs(YamlValue value, Optional<YamlValue> front) {
    named(value, "'tabs'");
    List<String> ids = Shape.items(value).stream().flatMap(v -> viewId(v).stream()).toList();
    int index = front.flatMap(this::viewId).map(ids::indexOf).orElse(0);
    if (index < 0) {
      problems.add(front.get().place().error("'front' must be one of its tabs: " + String.join(", ", ids)));
    }
    return ids.isEmpty() ? Optional.empty() : Optional.of(new Layout.Tabs(ids, Math.max(0, index)));
  }

  private Optional<Layout> split(Layout.Direction direction, YamlValue value) {
    named(value, direction == Layout.Direction.ROW ? "'row'" : "'column'");
    List<Layout> parts = new ArrayList<>();
    List<Double> weights = new ArrayList<>();
    for (YamlValue item : Shape.items(value)) {
      read(item).ifPresent(part -> {
        parts.add(part);
        weights.add(weight(item));
      });
    }
    return switch (parts.size()) {
      case 0 -> Optional.empty();
      case 1 -> Optional.of(parts.getFirst());
      default -> Optional.of(new Layout.Split(direction, parts, weights));
    };
  }

  private void named(YamlValue value, String what) {
    if (Shape.items(value).isEmpty()) {
      problems.add(value.place()
          .error(what + " names no view; write at least one, for example [" + views.any().orElse("map") + "]"));
    }
  }

  private double weight(YamlValue item) {
    Optional<YamlValue> written = item instanceof YamlValue.Section s ? s.get("weight") : Optional.empty();
    return written.flatMap(w -> Shape.weight(w, new ArrayList<>())).orElse(1.0); // what is wrong with it has been said
  }
}
