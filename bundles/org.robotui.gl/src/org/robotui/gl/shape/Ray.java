package org.robotui.gl.shape;

import org.robotui.geometry.Vector3;

/**
 * The line of sight under the pointer, in the fixed frame.
 *
 * @param origin where it begins, metres
 * @param direction unit length
 */
public record Ray(Vector3 origin, Vector3 direction) {
  /**
   * The place on the ray.
   *
   * @param distance from the origin, metres
   * @return the place
   */
  public Vector3 at(double distance) {
    return origin.plus(direction.times(distance));
  }
}
