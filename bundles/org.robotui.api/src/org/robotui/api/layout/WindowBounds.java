package org.robotui.api.layout;

/**
 * Where a window lies, in points of the desktop, which grow to the right and down.
 *
 * @param x of its left side; may be negative
 * @param y of its upper side; may be negative
 * @param width positive
 * @param height positive
 */
public record WindowBounds(int x, int y, int width, int height) {
  /**
   * Checks.
   *
   * @param x of its left side
   * @param y of its upper side
   * @param width positive
   * @param height positive
   */
  public WindowBounds {
    if (width <= 0 || height <= 0) {
      throw new IllegalArgumentException("a window of " + width + " x " + height + " points cannot be seen");
    }
  }
}
