package org.robotui.gl.internal.draw;

import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Box3;

/** Tells what lies between the near and the far end of what is seen. */
final class Clip {
  private static final int CORNERS = 8;

  private Clip() {}

  /** Whether all of a box does. */
  static boolean holds(Matrix clipFromShape, Box3 box) {
    boolean inside = true;
    for (int corner = 0; corner < CORNERS && inside; corner++) {
      double[] at = clipFromShape.apply(new Vector3(
          ((corner & 1) == 0 ? box.low() : box.high()).x(), ((corner & 2) == 0 ? box.low() : box.high()).y(),
          ((corner & 4) == 0 ? box.low() : box.high()).z()));
      inside = at[3] > 0 && at[2] > -at[3] && at[2] < at[3];
    }
    return inside;
  }
}
