package org.robotui.data.geometry;

import org.robotui.data.Data;
import org.robotui.geometry.Vector3;

/** A velocity: linear in metres per second, angular in radians per second. */
public interface Twist extends Data {
  /**
   * The linear part.
   *
   * @return metres per second
   */
  Vector3 linear();

  /**
   * The angular part: rotation about the axes.
   *
   * @return radians per second
   */
  Vector3 angular();
}
