package org.robotui.sim.internal.sensor;

/**
 * A planar laser scanner.
 *
 * @param fieldOfView radians, symmetric about the front
 * @param beams two or more
 * @param rangeMin metres
 * @param rangeMax metres; beyond it there is no echo
 * @param noise standard deviation, metres
 * @param forward of the scanner before the robot's centre, metres
 * @param height above the floor, metres
 * @param frequency scans a second
 */
public record LaserSpec(
    double fieldOfView,
    int beams,
    double rangeMin,
    double rangeMax,
    double noise,
    double forward,
    double height,
    double frequency) {
  /** Like a SICK LMS 200 in its fine mode. */
  public static final LaserSpec DEMO = new LaserSpec(Math.toRadians(180), 361, 0.05, 8.0, 0.008, 0.12, 0.30, 20);

  public LaserSpec {
    if (beams < 2 || !(rangeMin >= 0 && rangeMin < rangeMax) || !(fieldOfView > 0)) {
      throw new IllegalArgumentException("a laser needs two beams, a field of view and rangeMin below rangeMax");
    }
  }

  public double angleMin() {
    return -fieldOfView / 2;
  }

  public double increment() {
    return fieldOfView / (beams - 1);
  }
}
