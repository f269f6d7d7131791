package org.robotui.gl.internal.draw;

/**
 * How fine surfaces are drawn.
 *
 * @param pixels within which corners may be moved
 * @param openness share of open edges up to which a mesh is taken for the surface of a body, of which nobody sees what
 * faces away
 */
public record Fineness(double pixels, double openness) {
  /** As they are: where the graphics card draws, and where parts are searched. */
  public static final Fineness EXACT = new Fineness(0, -1);
  /** As fine as is seen. */
  public static final Fineness AT_REST = new Fineness(1, 0);
  /** As fine as is needed while the camera moves. */
  public static final Fineness MOVING = new Fineness(3, 0.03);

  boolean isExact() {
    return pixels == 0;
  }
}
