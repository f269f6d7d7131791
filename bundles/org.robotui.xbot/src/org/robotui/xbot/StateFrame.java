package org.robotui.xbot;

import java.util.List;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;

/**
 * The robot in one cycle of its control.
 *
 * @param cycle its number, from 1
 * @param sensedNanos when it was measured, by the monotonic clock of the machine, which is that of
 * {@link System#nanoTime} here
 * @param hardware what the hardware says
 * @param joints in the order of the board
 * @param imus in the order of the board
 * @param forceTorques in the order of the board
 */
public record StateFrame(
    long cycle, long sensedNanos, Hardware hardware, List<Joint> joints, List<Imu> imus,
    List<ForceTorque> forceTorques) {
  /** What the hardware says. */
  public enum Hardware {
    /** All is well. */
    OK,
    /** Nothing came in time: what is told is the last there was. */
    TIMEOUT,
    /** It cannot go on. */
    FAULT,
    /** An emergency stop is pressed, or cannot be read: all joints are safe. */
    EMERGENCY_STOP
  }

  /** Where the reference of a joint comes from. */
  public enum Control {
    /** No plugin owns it: it holds. */
    FREE,
    /** Its plugin commands it. */
    COMMANDED,
    /** Its plugin missed: it holds. */
    HOLDING,
    /** Its plugin missed too often or died. */
    SAFE
  }

  /**
   * One joint, in SI units; temperatures in degrees Celsius, NaN where unknown.
   *
   * @param linkPosition behind the gears
   * @param motorPosition of the motor, seen from the link's side
   * @param linkVelocity per second
   * @param motorVelocity per second
   * @param effort newton metres or newton
   * @param reference what went to the hardware, after limits
   * @param mode bits: 1 position, 2 velocity, 4 effort, 8 stiffness, 16 damping
   * @param motorTemperature of the motor
   * @param driverTemperature of its electronics
   * @param faults bits of the hardware
   * @param clamped commands that a limit cut
   * @param rejected commands that were no numbers, or not allowed
   * @param owner index of the plugin that owns it, or -1
   * @param control where the reference comes from
   */
  public record Joint(
      double linkPosition,
      double motorPosition,
      double linkVelocity,
      double motorVelocity,
      double effort,
      Reference reference,
      int mode,
      double motorTemperature,
      double driverTemperature,
      long faults,
      long clamped,
      long rejected,
      int owner,
      Control control) {}

  /**
   * What a joint is told.
   *
   * @param position radians or metres
   * @param velocity per second
   * @param effort newton metres or newton
   * @param stiffness newton metres per radian or newton per metre
   * @param damping the same times seconds
   */
  public record Reference(double position, double velocity, double effort, double stiffness, double damping) {}

  /**
   * One inertial measurement unit.
   *
   * @param orientation of the sensor in the world
   * @param angularVelocity radians per second
   * @param linearAcceleration metres per second squared
   */
  public record Imu(Quaternion orientation, Vector3 angularVelocity, Vector3 linearAcceleration) {}

  /**
   * One force-torque sensor.
   *
   * @param force newton
   * @param torque newton metres
   */
  public record ForceTorque(Vector3 force, Vector3 torque) {}
}
