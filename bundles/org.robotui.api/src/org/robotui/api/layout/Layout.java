package org.robotui.api.layout;

import java.util.List;

/** Which views lie where, as a tree. */
public sealed interface Layout {
  /**
   * The views that have a place.
   *
   * @return their ids, in the order in which they are laid out
   */
  default List<String> views() {
    return switch (this) {
      case View view -> List.of(view.uic());
      case Tabs tabs -> tabs.uics();
      case Split split -> split.parts().stream().flatMap(part -> part.views().stream()).toList();
    };
  }

  /** How a split lies its parts out. */
  enum Direction {
    /** Side by side, left to right. */
    ROW,
    /** One above the other, top to bottom. */
    COLUMN
  }

  /**
   * One view.
   *
   * @param uic id of the UIC within the RUIC
   */
  record View(String uic) implements Layout {}

  /**
   * Views of which one is seen at a time.
   *
   * @param uics ids
   * @param front which one is seen first, from 0
   */
  record Tabs(List<String> uics, int front) implements Layout {
    /**
     * Copies the list and checks.
     *
     * @param uics ids; none where a window has no view
     * @param front which one is seen first
     */
    public Tabs {
      uics = List.copyOf(uics);
      if (front < 0 || front > 0 && front >= uics.size()) {
        throw new IllegalArgumentException("of " + uics.size() + " tabs none is number " + front);
      }
    }

    /**
     * Tabs of which the first is seen first.
     *
     * @param uics ids
     */
    public Tabs(List<String> uics) {
      this(uics, 0);
    }
  }

  /**
   * Parts beside each other.
   *
   * @param direction how they lie
   * @param parts at least two
   * @param weights a share per part, positive
   */
  record Split(Direction direction, List<Layout> parts, List<Double> weights) implements Layout {
    /**
     * Copies and checks.
     *
     * @param direction how they lie
     * @param parts the parts
     * @param weights a share per part
     */
    public Split {
      parts = List.copyOf(parts);
      weights = List.copyOf(weights);
      if (parts.size() != weights.size() || parts.size() < 2 || weights.stream().anyMatch(w -> !(w > 0))) {
        throw new IllegalArgumentException("a split has at least two parts with a positive weight each");
      }
    }
  }
}
