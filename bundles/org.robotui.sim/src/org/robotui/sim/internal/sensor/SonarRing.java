package org.robotui.sim.internal.sensor;

import java.util.List;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import java.util.function.Supplier;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

/** Sixteen ultrasonic sensors around the body, eight to the front and eight to the rear. For one thread. */
public final class SonarRing {
  public static final double CONE = Math.toRadians(26);
  public static final double RANGE_MIN = 0.10;
  public static final double RANGE_MAX = 5.0;
  public static final double HEIGHT = 0.22;
  private static final int RAYS = 9;
  private static final double NOISE = 0.01;
  private static final double RADIUS = 0.21;
  private static final double[] DEGREES = {
    90, 50, 30, 10, -10, -30, -50, -90, -90, -130, -150, -170, 170, 150, 130, 90
  };

  private final Supplier<World> world;
  private final RandomGenerator random;
  private final List<Pose2> mounts;

  public SonarRing(Supplier<World> world, RandomGenerator random) {
    this.world = world;
    this.random = random;
    mounts = IntStream.range(0, DEGREES.length).mapToObj(SonarRing::mount).toList();
  }

  private static Pose2 mount(int index) {
    double angle = Math.toRadians(DEGREES[index]);
    boolean sideways = Math.abs(DEGREES[index]) == 90;
    double x = sideways ? (index < 8 ? 0.11 : -0.11) : RADIUS * Math.cos(angle);
    return new Pose2(x, RADIUS * Math.sin(angle) * (sideways ? 0.75 : 1), angle);
  }

  public int count() {
    return mounts.size();
  }

  /** Where a sensor sits on the robot, and where it looks. */
  public Pose2 mount(Pose2 robot, int index) {
    return robot.times(mounts.get(index));
  }

  /** The distance to the nearest echo in the cone, metres; infinite without one. */
  public double measure(Pose2 robot, int index) {
    Pose2 eye = mount(robot, index);
    double nearest = Double.POSITIVE_INFINITY;
    for (int ray = 0; ray < RAYS; ray++) {
      double angle = eye.yaw() - CONE / 2 + CONE * ray / (RAYS - 1);
      nearest = Math.min(nearest, world.get().range(eye.x(), eye.y(), angle, HEIGHT, RANGE_MAX));
    }
    double noisy = nearest + NOISE * random.nextGaussian();
    return noisy > RANGE_MAX ? Double.POSITIVE_INFINITY : Math.max(RANGE_MIN, noisy);
  }
}
