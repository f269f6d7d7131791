package org.robotui.sim.internal.robot;

import java.util.random.RandomGenerator;
import org.robotui.sim.internal.world.Pose2;

/**
 * Stands in for a particle filter: an estimate of the pose in the map that is carried by odometry and pulled to the
 * truth while it is close enough to be recognised. A user who sets a wrong pose sees a lost robot. For one thread.
 */
public final class Localisation {
  private static final double TIME_CONSTANT = 2.5;
  private static final double CAPTURE_DISTANCE = 1.2;
  private static final double CAPTURE_ANGLE = Math.toRadians(40);
  private static final double JITTER = 0.004;

  private final RandomGenerator random;
  private Pose2 mapFromOdometry;
  private double error;

  public Localisation(RandomGenerator random, Pose2 start) {
    this.random = random;
    mapFromOdometry = start;
  }

  public Pose2 mapFromOdometry() {
    return mapFromOdometry;
  }

  public Pose2 estimate(Pose2 odometry) {
    return mapFromOdometry.times(odometry);
  }

  /** Whether the estimate is too far off to find back by itself. */
  public boolean isLost() {
    return error > CAPTURE_DISTANCE;
  }

  /** Believes a pose from outside. */
  public void set(Pose2 estimate, Pose2 odometry) {
    mapFromOdometry = estimate.times(odometry.inverse());
  }

  /** Compares with the truth, as a scan matcher would; called every {@code dt} seconds. */
  public void update(Pose2 truth, Pose2 odometry, double dt, boolean moving) {
    Pose2 estimate = estimate(odometry);
    Pose2 off = estimate.inverse().times(truth);
    double distance = Math.hypot(off.x(), off.y());
    boolean captured = distance < CAPTURE_DISTANCE && Math.abs(off.yaw()) < CAPTURE_ANGLE;
    error = captured ? distance : Math.max(distance, 2 * CAPTURE_DISTANCE);
    if (captured) {
      double gain = 1 - Math.exp(-dt / TIME_CONSTANT);
      double jitter = moving ? JITTER : 0;
      Pose2 correction = new Pose2(
          gain * off.x() + jitter * random.nextGaussian(),
          gain * off.y() + jitter * random.nextGaussian(),
          gain * off.yaw() + jitter * 0.5 * random.nextGaussian());
      set(estimate.times(correction), odometry);
    }
  }
}
