package org.robotui.data.joint;

import java.util.List;
import java.util.Set;
import org.robotui.data.Data;

/**
 * How a robot's control drives its joints: what is measured beside what was sent to the hardware, after all limits.
 *
 * @param joints one entry a joint, in the order of the robot's control
 */
public record JointControl(List<Joint> joints) implements Data {
  /** Where the reference of a joint comes from. */
  public enum Source {
    /** Nobody owns it: it holds. */
    FREE,
    /** Its owner commands it. */
    COMMANDED,
    /** Its owner missed its time: it holds. */
    HOLDING,
    /** Its owner missed too often, or died: it is in its safe state until it is given anew. */
    SAFE
  }

  /**
   * One joint. Positions are in radians or metres, velocities per second, efforts in newton metres or newton.
   *
   * @param name its name in the robot's model
   * @param measured what its sensors say
   * @param reference what was sent to it
   * @param modes what of the reference is meant
   * @param source where the reference comes from
   * @param owner the plugin that owns it, empty where none does
   * @param faults bits of the hardware; 0 is well
   * @param clamped commands that a limit cut
   * @param rejected commands that were not numbers or not allowed
   */
  public record Joint(
      String name,
      Measured measured,
      Reference reference,
      Set<JointMode> modes,
      Source source,
      String owner,
      long faults,
      long clamped,
      long rejected) {
    /**
     * Copies the modes.
     *
     * @param name its name
     * @param measured what its sensors say
     * @param reference what was sent to it
     * @param modes what of the reference is meant
     * @param source where the reference comes from
     * @param owner the plugin that owns it
     * @param faults bits of the hardware
     * @param clamped commands that a limit cut
     * @param rejected commands that were not allowed
     */
    public Joint {
      modes = Set.copyOf(modes);
    }
  }

  /**
   * What sensors say; NaN where there is none.
   *
   * @param position of the link
   * @param motorPosition of the motor, behind the elastic part
   * @param velocity of the link
   * @param motorVelocity of the motor
   * @param effort torque or force
   * @param motorTemperature degrees Celsius
   * @param driverTemperature degrees Celsius
   */
  public record Measured(
      double position,
      double motorPosition,
      double velocity,
      double motorVelocity,
      double effort,
      double motorTemperature,
      double driverTemperature) {}

  /**
   * What a joint is told.
   *
   * @param position radians or metres
   * @param velocity per second
   * @param effort newton metres or newton
   * @param stiffness newton metres per radian or newton per metre
   * @param damping newton metre seconds per radian or newton seconds per metre
   */
  public record Reference(double position, double velocity, double effort, double stiffness, double damping) {}

  /**
   * Copies the list.
   *
   * @param joints one entry a joint
   */
  public JointControl {
    joints = List.copyOf(joints);
  }
}
