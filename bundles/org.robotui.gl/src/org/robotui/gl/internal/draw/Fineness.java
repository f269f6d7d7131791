package org.robotui.gl.internal.draw;

/**
 * How fine surfaces are drawn.
 *
 * @param pixels within which corners may be moved
 */
public record Fineness(double pixels) {
  /** As they are: where the graphics card draws, and where parts are searched. */
  public static final Fineness EXACT = new Fineness(0);
  /** As fine as is seen. */
  public static final Fineness AT_REST = new Fineness(1);
  /** As fine as is needed while the camera moves. */
  public static final Fineness MOVING = new Fineness(3);

  boolean isExact() {
    return pixels == 0;
  }
}
