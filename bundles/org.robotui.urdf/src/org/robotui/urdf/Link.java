package org.robotui.urdf;

import java.util.List;
import java.util.Optional;

/**
 * A rigid part of a robot.
 *
 * @param name unique in the model
 * @param inertial its mass
 * @param visuals what is seen of it
 * @param collisions what of it can touch things
 */
public record Link(String name, Optional<Inertial> inertial, List<Visual> visuals, List<Collision> collisions) {
  /**
   * Copies the lists.
   *
   * @param name unique
   * @param inertial its mass
   * @param visuals seen
   * @param collisions touching
   */
  public Link {
    visuals = List.copyOf(visuals);
    collisions = List.copyOf(collisions);
  }
}
