package org.robotui.entity.robot;

import java.util.List;
import java.util.Optional;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * A robot as seen from above.
 *
 * @param name what users call it
 * @param fixedFromBase where it is and where it looks
 * @param radius of the circle that stands for it without an outline, metres
 * @param outline corners in the fixed frame, where its outline is known
 * @param word the pose in words, for tooltips
 */
public record Body(
    String name, RigidTransform fixedFromBase, double radius, Optional<List<Vector3>> outline, String word) {
  /**
   * Copies and checks.
   *
   * @param name what users call it
   * @param fixedFromBase where it is and where it looks
   * @param radius metres, positive
   * @param outline corners in the fixed frame
   * @param word the pose in words
   */
  public Body {
    outline = outline.map(List::copyOf);
    if (!(radius > 0)) {
      throw new IllegalArgumentException("the radius of a robot must be positive, is " + radius);
    }
  }
}
