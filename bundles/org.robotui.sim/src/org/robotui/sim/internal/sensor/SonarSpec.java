package org.robotui.sim.internal.sensor;

import java.util.List;
import java.util.stream.IntStream;
import org.robotui.sim.internal.world.Pose2;

/**
 * A ring of ultrasonic sensors.
 *
 * @param mounts where each sensor sits on the robot, and where it looks
 * @param cone the opening of each, radians
 * @param rangeMin metres
 * @param rangeMax metres; beyond it there is no echo
 * @param noise standard deviation, metres
 * @param height above the floor, metres
 */
public record SonarSpec(List<Pose2> mounts, double cone, double rangeMin, double rangeMax, double noise,
    double height) {
  /** No sonars at all. */
  public static final SonarSpec NONE = new SonarSpec(List.of(), Math.toRadians(26), 0.1, 5, 0, 0.1);
  /** Sixteen, eight to the front and eight to the rear, at the angles of a Pioneer 3-DX. */
  public static final SonarSpec PIONEER = new SonarSpec(
      ring(0.21, 90, 50, 30, 10, -10, -30, -50, -90, -90, -130, -150, -170, 170, 150, 130, 90), Math.toRadians(26),
      0.10, 5.0, 0.01, 0.22);

  public SonarSpec {
    mounts = List.copyOf(mounts);
  }

  public int count() {
    return mounts.size();
  }

  private static List<Pose2> ring(double radius, double... degrees) {
    return IntStream.range(0, degrees.length)
        .mapToObj(index -> mount(radius, degrees[index], index < degrees.length / 2)).toList();
  }

  /** Those that look sideways sit before and behind the wheels. */
  private static Pose2 mount(double radius, double degrees, boolean front) {
    double angle = Math.toRadians(degrees);
    boolean sideways = Math.abs(degrees) == 90;
    double x = sideways ? (front ? 0.11 : -0.11) : radius * Math.cos(angle);
    return new Pose2(x, radius * Math.sin(angle) * (sideways ? 0.75 : 1), angle);
  }
}
