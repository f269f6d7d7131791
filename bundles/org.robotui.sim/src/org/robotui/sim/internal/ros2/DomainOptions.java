package org.robotui.sim.internal.ros2;

import java.util.OptionalInt;

/**
 * In which domain of ROS 2 the robot is.
 *
 * @param domain its number, 0 to 232; empty for one in which nobody is on this machine
 * @param subnet whether it can be reached from other machines
 */
public record DomainOptions(OptionalInt domain, boolean subnet) {
  /** The highest number of a domain. */
  public static final int MOST = 232;
}
