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
   * @param uics ids, at least one; the first is seen first
   */
  record Tabs(List<String> uics) implements Layout {
    /**
     * Copies the list.
     *
     * @param uics ids
     */
    public Tabs {
      uics = List.copyOf(uics);
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
