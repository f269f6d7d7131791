package org.robotui.ui.diagram;

import org.robotui.ui.Health;
import org.robotui.ui.Role;

/**
 * A thing of a diagram.
 *
 * @param key unique in the diagram, with equals and hashCode
 * @param x of the left edge
 * @param y of the upper edge
 * @param width points
 * @param height points
 * @param form how it looks
 * @param title what it is
 * @param note a second line in smaller letters, may be empty
 * @param health the dot before the title; no dot for {@link Health#NONE}
 * @param role the colour of its edge
 */
public record Box(
    Object key, double x, double y, double width, double height, Form form, String title, String note, Health health,
    Role role) {
  /** How a box looks. */
  public enum Form {
    /** With corners that are a little round. */
    ROUNDED,
    /** With round ends. */
    PILL,
    /** A frame around other boxes, its title at the upper edge; painted below all others. */
    GROUP
  }

  /** The height of a box with a title alone, points. */
  public static final int LOW = 28;

  /** The height of a box with a note below the title, points. */
  public static final int HIGH = 40;

  /**
   * The same box at another place.
   *
   * @param left of its left edge
   * @param top of its upper edge
   * @return the box
   */
  public Box at(double left, double top) {
    return new Box(key, left, top, width, height, form, title, note, health, role);
  }

  /**
   * Whether a place lies in it.
   *
   * @param px points from the left
   * @param py points from the top
   * @return true within its edges
   */
  public boolean contains(double px, double py) {
    return px >= x && px < x + width && py >= y && py < y + height;
  }
}
