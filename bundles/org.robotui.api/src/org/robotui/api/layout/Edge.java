package org.robotui.api.layout;

import org.robotui.api.layout.Layout.Direction;

/** A side of a rectangle. */
public enum Edge {
  /** The left one. */
  LEFT(Direction.ROW, true),
  /** The right one. */
  RIGHT(Direction.ROW, false),
  /** The upper one. */
  TOP(Direction.COLUMN, true),
  /** The lower one. */
  BOTTOM(Direction.COLUMN, false);

  private final Direction direction;
  private final boolean before;

  Edge(Direction direction, boolean before) {
    this.direction = direction;
    this.before = before;
  }

  /**
   * The direction of a split whose one part lies at this side of the other.
   *
   * @return row or column
   */
  public Direction direction() {
    return direction;
  }

  /**
   * Whether what is at this side comes first in reading order.
   *
   * @return true for left and top
   */
  public boolean isBefore() {
    return before;
  }
}
