package org.robotui.sim.internal.robot;

/**
 * A head on the robot that looks around by itself.
 *
 * @param pan to the left, radians
 * @param tilt downwards, radians
 * @param panSpeed radians per second
 * @param tiltSpeed radians per second
 */
public record Head(double pan, double tilt, double panSpeed, double tiltSpeed) {
  public static final double HEIGHT = 0.80;
  /** Of the tilting part above the panning one, metres. */
  public static final double NECK = 0.06;
  private static final double PAN = 0.9;
  private static final double PAN_RATE = 2 * Math.PI / 16;
  private static final double TILT = 0.25;
  private static final double TILT_RATE = 2 * Math.PI / 11;

  /** @param time seconds since the start of the simulation */
  public static Head at(double time) {
    return new Head(
        PAN * Math.sin(PAN_RATE * time), TILT * Math.sin(TILT_RATE * time),
        PAN * PAN_RATE * Math.cos(PAN_RATE * time), TILT * TILT_RATE * Math.cos(TILT_RATE * time));
  }
}
