package org.robotui.sim.internal.sensor;

import java.util.random.RandomGenerator;
import java.util.function.Supplier;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

/** Measures what a laser scanner would. For one thread. */
public final class LaserScanner {
  private final Supplier<World> world;
  private final LaserSpec spec;
  private final RandomGenerator random;

  public LaserScanner(Supplier<World> world, LaserSpec spec, RandomGenerator random) {
    this.world = world;
    this.spec = spec;
    this.random = random;
  }

  public LaserSpec spec() {
    return spec;
  }

  /** Ranges in metres from the right to the left, infinite where there is no echo. */
  public float[] scan(Pose2 robot) {
    Pose2 eye = robot.times(new Pose2(spec.forward(), 0, 0));
    float[] ranges = new float[spec.beams()];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = (float) measure(eye, eye.yaw() + spec.angleMin() + i * spec.increment());
    }
    return ranges;
  }

  private double measure(Pose2 eye, double angle) {
    double range = world.get().range(eye.x(), eye.y(), angle, spec.height(), spec.rangeMax());
    double noisy = range + spec.noise() * random.nextGaussian();
    return noisy > spec.rangeMax() ? Double.POSITIVE_INFINITY : Math.max(spec.rangeMin(), noisy);
  }
}
