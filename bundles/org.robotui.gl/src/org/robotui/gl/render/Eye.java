package org.robotui.gl.render;

import org.robotui.geometry.RigidTransform;

/**
 * From where a scene is seen.
 *
 * @param fixedFromEye where the eye is; it looks along its x axis, y to the left, z up (REP 103)
 * @param projection how depth shows
 * @param near what is nearer is not seen, metres, above 0
 * @param far what is farther is not seen, metres
 */
public record Eye(RigidTransform fixedFromEye, Projection projection, double near, double far) {
  /** How depth shows. */
  public sealed interface Projection {
    /**
     * As a camera sees.
     *
     * @param fieldOfView angle from the bottom to the top of the picture, radians
     */
    record Perspective(double fieldOfView) implements Projection {}

    /**
     * As a plan is drawn: far things are as large as near ones.
     *
     * @param height what the picture shows from bottom to top, metres
     */
    record Parallel(double height) implements Projection {}
  }

  /**
   * Checks the depths.
   *
   * @param fixedFromEye where the eye is
   * @param projection how depth shows
   * @param near metres
   * @param far metres
   */
  public Eye {
    if (!(near > 0) || !(far > near)) {
      throw new IllegalArgumentException("near " + near + " and far " + far);
    }
  }
}
