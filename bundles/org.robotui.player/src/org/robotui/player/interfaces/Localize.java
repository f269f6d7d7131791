package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Where a robot is on a map, with several guesses. The interface {@code localize}. */
public final class Localize {

  /** Data: hypotheses. */
  public static final Kind.Data<Hypotheses> HYPOTHESES = new Kind.Data<>("localize", "hypotheses", Hypotheses.class);

  /** Request: set pose by {@link Estimate}; the answer is empty. */
  public static final Kind.Request<Estimate, Empty> SET_POSE =
      new Kind.Request<>("localize", "set_pose", Estimate.class, Empty.class);

  /** Request: get particles; answered by {@link Particles}. */
  public static final Kind.Request<Empty, Particles> GET_PARTICLES =
      new Kind.Request<>("localize", "get_particles", Empty.class, Particles.class);

  private Localize() {}

  /**
   * All guesses.
   *
   * @param pending measurements that were not used yet
   * @param pendingTime the stamp of the last one that was used, seconds
   * @param hypotheses best first or not, as the driver has them
   */
  public record Hypotheses(long pending, double pendingTime, List<Hypothesis> hypotheses) {}

  /**
   * One guess.
   *
   * @param mean the most likely place, on the map
   * @param covariance xx m^2, yy m^2, aa rad^2, xy m^2, ya m rad, xa m rad
   * @param weight 0 to 1
   */
  public record Hypothesis(Pose2d mean, double[] covariance, double weight) {}

  /**
   * Where the robot is said to be.
   *
   * @param mean the most likely place, on the map
   * @param covariance xx m^2, yy m^2, aa rad^2, xy m^2, ya m rad, xa m rad
   */
  public record Estimate(Pose2d mean, double[] covariance) {}

  /**
   * A sample of the filter.
   *
   * @param mean the most likely place, on the map
   * @param variance of the place, as the driver gives it
   * @param particles in no order
   */
  public record Particles(Pose2d mean, double variance, List<Particle> particles) {}

  /**
   * One of them.
   *
   * @param pose on the map
   * @param weight 0 to 1
   */
  public record Particle(Pose2d pose, double weight) {}
}
