package org.robotui.sim.internal.sensor;

import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

/** Measures what a ring of ultrasonic sensors would. For one thread. */
public final class SonarRing {
  private static final int RAYS = 9;

  private final Supplier<World> world;
  private final SonarSpec spec;
  private final RandomGenerator random;

  public SonarRing(Supplier<World> world, SonarSpec spec, RandomGenerator random) {
    this.world = world;
    this.spec = spec;
    this.random = random;
  }

  public SonarSpec spec() {
    return spec;
  }

  public int count() {
    return spec.count();
  }

  /** Where a sensor sits on the robot, and where it looks. */
  public Pose2 mount(Pose2 robot, int index) {
    return robot.times(spec.mounts().get(index));
  }

  /** The distance to the nearest echo in the cone, metres; infinite without one. */
  public double measure(Pose2 robot, int index) {
    Pose2 eye = mount(robot, index);
    double nearest = Double.POSITIVE_INFINITY;
    for (int ray = 0; ray < RAYS; ray++) {
      double angle = eye.yaw() - spec.cone() / 2 + spec.cone() * ray / (RAYS - 1);
      nearest = Math.min(nearest, world.get().range(eye.x(), eye.y(), angle, spec.height(), spec.rangeMax()));
    }
    double noisy = nearest + spec.noise() * random.nextGaussian();
    return noisy > spec.rangeMax() ? Double.POSITIVE_INFINITY : Math.max(spec.rangeMin(), noisy);
  }
}
