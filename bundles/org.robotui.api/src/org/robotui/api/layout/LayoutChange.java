package org.robotui.api.layout;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.robotui.api.layout.Layout.Direction;
import org.robotui.api.layout.Layout.Split;
import org.robotui.api.layout.Layout.Tabs;
import org.robotui.api.layout.Layout.View;

/** Changes of layouts. Pure functions: what they are given stays as it was. */
public final class LayoutChange {
  /** How much of a window a view takes that is dropped at its side. */
  private static final double BORDER_SHARE = 0.3;

  private LayoutChange() {}

  /**
   * A layout without some of its views; what is left takes their room.
   *
   * @param layout the layout
   * @param views ids
   * @return without any view, tabs of which there are none
   */
  public static Layout without(Layout layout, Collection<String> views) {
    return views.isEmpty() ? layout : pruned(layout, views).orElse(new Tabs(List.of()));
  }

  /**
   * A view put among the tabs of another one, in front of them.
   *
   * @param layout has the other, but not the view
   * @param view the view
   * @param target where
   * @return the layout
   */
  public static Layout tabbed(Layout layout, String view, DropTarget.Tab target) {
    return replaced(layout, target.view(), stack -> {
      List<String> tabs = new ArrayList<>(stack.views());
      int at = Math.clamp(target.index(), 0, tabs.size());
      tabs.add(at, view);
      return new Tabs(tabs, at);
    });
  }

  /**
   * A view put beside the tabs of another one.
   *
   * @param layout has the other, but not the view
   * @param view the view
   * @param target where
   * @return the layout
   */
  public static Layout beside(Layout layout, String view, DropTarget.Side target) {
    return replaced(layout, target.view(), stack -> pair(stack, new View(view), target.edge(), 0.5));
  }

  /**
   * A view put along a whole side of a layout.
   *
   * @param layout the layout
   * @param view the view
   * @param edge the side
   * @return the layout
   */
  public static Layout bordered(Layout layout, String view, Edge edge) {
    return layout.views().isEmpty() ? new View(view) : flat(pair(layout, new View(view), edge, BORDER_SHARE));
  }

  /**
   * A layout in which a view is in front of its tabs.
   *
   * @param layout the layout
   * @param view the view
   * @return the layout
   */
  public static Layout fronted(Layout layout, String view) {
    return replaced(layout, view,
        stack -> stack instanceof Tabs tabs ? new Tabs(tabs.uics(), tabs.uics().indexOf(view)) : stack);
  }

  /**
   * A layout in which the first of all tabs is in front: to compare layouts by where views lie alone.
   *
   * @param layout the layout
   * @return the layout
   */
  public static Layout unfronted(Layout layout) {
    return switch (layout) {
      case View view -> view;
      case Tabs tabs -> new Tabs(tabs.uics());
      case Split split -> new Split(split.direction(), split.parts().stream().map(LayoutChange::unfronted).toList(),
          split.weights());
    };
  }

  /**
   * A layout with other shares in one of its splits.
   *
   * @param layout the layout
   * @param place which split: the places of parts within parts, from the outermost, from 0; empty for the outermost
   * @param weights as many as it has parts, positive
   * @return the layout; as it was where there is no such split
   */
  public static Layout weighted(Layout layout, List<Integer> place, List<Double> weights) {
    if (!(layout instanceof Split split)) {
      return layout;
    }
    if (place.isEmpty()) {
      return weights.size() == split.parts().size() ? new Split(split.direction(), split.parts(), weights) : split;
    }
    int index = place.getFirst();
    if (index < 0 || index >= split.parts().size()) {
      return layout;
    }
    List<Layout> parts = new ArrayList<>(split.parts());
    parts.set(index, weighted(parts.get(index), place.subList(1, place.size()), weights));
    return new Split(split.direction(), parts, split.weights());
  }

  /**
   * The views among whose tabs one lies, with itself.
   *
   * @param layout the layout
   * @param view the view
   * @return their ids; none where it lies nowhere
   */
  public static List<String> mates(Layout layout, String view) {
    if (layout instanceof Split split) {
      return split.parts().stream().filter(part -> part.views().contains(view)).findFirst()
          .map(part -> mates(part, view)).orElse(List.of());
    }
    return layout.views().contains(view) ? layout.views() : List.of();
  }

  /**
   * How many splits lie within one another.
   *
   * @param layout the layout
   * @return 0 for tabs and for a single view
   */
  static int depth(Layout layout) {
    return layout instanceof Split split ? 1 + split.parts().stream().mapToInt(LayoutChange::depth).max().orElse(0) : 0;
  }

  private static Optional<Layout> pruned(Layout layout, Collection<String> views) {
    return switch (layout) {
      case View v -> Optional.<Layout>of(v).filter(x -> !views.contains(v.uic()));
      case Tabs t -> pruned(t, views);
      case Split s -> split(s, views);
    };
  }

  /** Where the view in front goes, the next one comes to the front, else the one before. */
  private static Optional<Layout> pruned(Tabs tabs, Collection<String> views) {
    List<String> left = tabs.uics().stream().filter(id -> !views.contains(id)).toList();
    int before = (int) tabs.uics().stream().limit(tabs.front()).filter(id -> !views.contains(id)).count();
    return left.isEmpty() ? Optional.empty() : Optional.of(new Tabs(left, Math.min(before, left.size() - 1)));
  }

  private static Optional<Layout> split(Split split, Collection<String> views) {
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
      default -> Optional.of(flat(new Split(split.direction(), parts, weights)));
    };
  }

  private static Layout replaced(Layout layout, String view, UnaryOperator<Layout> change) {
    if (!layout.views().contains(view)) {
      return layout;
    }
    return switch (layout) {
      case View v -> change.apply(v);
      case Tabs t -> change.apply(t);
      case Split s -> flat(
          new Split(s.direction(), s.parts().stream().map(p -> replaced(p, view, change)).toList(), s.weights()));
    };
  }

  private static Split pair(Layout there, Layout added, Edge edge, double share) {
    return edge.isBefore() ? new Split(edge.direction(), List.of(added, there), List.of(share, 1 - share))
        : new Split(edge.direction(), List.of(there, added), List.of(1 - share, share));
  }

  /** A row within a row is a part of it: what the user then divides is what is seen. */
  private static Split flat(Split split) {
    Direction direction = split.direction();
    if (split.parts().stream().noneMatch(p -> p instanceof Split inner && inner.direction() == direction)) {
      return split;
    }
    List<Layout> parts = new ArrayList<>();
    List<Double> weights = new ArrayList<>();
    IntStream.range(0, split.parts().size()).forEach(i -> {
      double weight = split.weights().get(i);
      if (split.parts().get(i) instanceof Split inner && inner.direction() == direction) {
        double all = inner.weights().stream().mapToDouble(w -> w).sum();
        parts.addAll(inner.parts());
        inner.weights().forEach(w -> weights.add(weight * w / all));
      } else {
        parts.add(split.parts().get(i));
        weights.add(weight);
      }
    });
    return new Split(direction, parts, weights);
  }
}
