package org.robotui.sim.internal.sensor;

/**
 * A spinning scanner with several beams above one another.
 *
 * @param columns directions around
 * @param rings beams above one another, two or more
 * @param lowest elevation of the lowest ring, radians
 * @param highest elevation of the highest ring, radians
 * @param rangeMin metres; what is nearer gives no echo
 * @param rangeMax metres; what is farther gives no echo
 * @param noise standard deviation of a range, metres
 * @param lost share of the beams whose echo is not heard
 * @param forward of the scanner before the robot's centre, metres
 * @param height above the floor, metres
 */
public record LidarSpec(
    int columns,
    int rings,
    double lowest,
    double highest,
    double rangeMin,
    double rangeMax,
    double noise,
    double lost,
    double forward,
    double height) {
  public static final LidarSpec DEMO =
      new LidarSpec(450, 32, Math.toRadians(-25), Math.toRadians(15), 0.25, 10, 0.012, 0.004, 0.1, 0.45);

  public LidarSpec {
    if (columns < 1 || rings < 2 || !(lowest < highest) || !(rangeMin >= 0 && rangeMin < rangeMax)) {
      throw new IllegalArgumentException(
          "a lidar needs a column, two rings, and lowest and rangeMin below their opposites");
    }
  }

  double elevation(int ring) {
    return lowest + ring * (highest - lowest) / (rings - 1);
  }
}
