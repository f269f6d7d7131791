package org.robotui.data.joint;

import java.util.List;
import org.robotui.data.Data;
import org.robotui.data.Delivery;

/**
 * The joints that a robot's control can command, with their limits. It is true until the next one.
 *
 * @param joints in the order of the robot's control
 * @param chains from base to tip; a joint may be in several, or in none
 */
@Delivery(expires = false)
public record JointModel(List<Joint> joints, List<Chain> chains) implements Data {
  /** What a joint does. */
  public enum Type {
    /** Turns: radians. */
    REVOLUTE,
    /** Slides: metres. */
    PRISMATIC
  }

  /**
   * One joint.
   *
   * @param name its name in the robot's model
   * @param id its number in the robot's control
   * @param type what it does
   * @param lower least position, radians or metres; minus infinity where there is no limit
   * @param upper greatest position; infinity where there is no limit
   * @param velocity greatest speed, radians or metres per second
   * @param effort greatest torque or force, newton metres or newton
   */
  public record Joint(String name, int id, Type type, double lower, double upper, double velocity, double effort) {}

  /**
   * One chain.
   *
   * @param name its name
   * @param joints names of its joints
   */
  public record Chain(String name, List<String> joints) {
    /**
     * Copies the list.
     *
     * @param name its name
     * @param joints names of its joints
     */
    public Chain {
      joints = List.copyOf(joints);
    }
  }

  /**
   * Copies the lists.
   *
   * @param joints in the order of the robot's control
   * @param chains from base to tip
   */
  public JointModel {
    joints = List.copyOf(joints);
    chains = List.copyOf(chains);
  }
}
