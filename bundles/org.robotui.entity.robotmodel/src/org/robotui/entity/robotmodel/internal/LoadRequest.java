package org.robotui.entity.robotmodel.internal;

import java.util.List;
import org.robotui.data.joint.RobotDescription;

/**
 * What is to be loaded: another one asks for another load.
 *
 * @param description of the robot
 * @param collision with the forms that can touch
 * @param packages folders before those of the description
 */
record LoadRequest(RobotDescription description, boolean collision, List<String> packages) {
  /** Copies the list. */
  LoadRequest {
    packages = List.copyOf(packages);
  }
}
