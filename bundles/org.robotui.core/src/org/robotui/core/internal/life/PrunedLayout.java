package org.robotui.core.internal.life;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.layout.Layout;

/** A layout without some of its views; what is left takes their room. */
public final class PrunedLayout {
  private PrunedLayout() {}

  /** The layout without views of these ids; without any view, tabs of which there are none. */
  public static Layout without(Layout layout, List<String> views) {
    return views.isEmpty() ? layout : pruned(layout, views).orElse(new Layout.Tabs(List.of()));
  }

  private static Optional<Layout> pruned(Layout layout, List<String> views) {
    return switch (layout) {
      case Layout.View v -> Optional.<Layout>of(v).filter(x -> !views.contains(v.uic()));
      case Layout.Tabs t -> {
        List<String> left = t.uics().stream().filter(id -> !views.contains(id)).toList();
        yield left.isEmpty() ? Optional.empty() : Optional.of(new Layout.Tabs(left));
      }
      case Layout.Split s -> split(s, views);
    };
  }

  private static Optional<Layout> split(Layout.Split split, List<String> views) {
    List<Layout> parts = new ArrayList<>();
    List<Double> weights = new ArrayList<>();
    for (int i = 0; i < split.parts().size(); i++) {
      double weight = split.weights().get(i);
      pruned(split.parts().get(i), views).ifPresent(part -> {
        parts.add(part);
        weights.add(weight);
      });
    }
    return switch (parts.size()) {
      case 0 -> Optional.empty();
      case 1 -> Optional.of(parts.getFirst());
      default -> Optional.of(new Layout.Split(split.direction(), parts, weights));
    };
  }
}
