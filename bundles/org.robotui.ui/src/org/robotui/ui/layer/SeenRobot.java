package org.robotui.ui.layer;

import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * A robot on the map.
 *
 * @param name what users call it
 * @param fixedFromBase where it is and where it looks
 * @param speed metres per second, 0 where it is not known
 * @param number gives it its colour among the robots of a team, from 0
 * @param selected whether the user means it
 * @param stale whether what says where it is has become old
 */
public record SeenRobot(String name, RigidTransform fixedFromBase, double speed, int number, boolean selected,
    boolean stale) {
  /**
   * Where it is.
   *
   * @return the place in the fixed frame
   */
  public Vector3 at() {
    return fixedFromBase.translation();
  }
}
