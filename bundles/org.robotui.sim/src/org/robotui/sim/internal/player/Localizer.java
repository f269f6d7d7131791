package org.robotui.sim.internal.player;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.robotui.player.interfaces.Localize;
import org.robotui.player.layout.Empty;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.world.Pose2;

/** {@code localize:0}: one guess, with its spread. */
final class Localizer implements Part {
  private static final Rate RATE = new Rate(5);
  private static final int PARTICLES = 100;
  private static final long SEED = 7;

  private final Bench bench;
  private final ServedDevice device;

  /** Variances of the place, m^2, and of the heading, rad^2. */
  private record Spread(double place, double heading) {
    static Spread of(RobotState state) {
      return state.lost() ? new Spread(1, 0.5) : new Spread(0.003, 0.001);
    }

    double[] covariance() {
      return new double[]{place, place, heading, 0, 0, 0};
    }
  }

  Localizer(Bench bench) {
    this.bench = bench;
    device = bench.add("localize", 0, bench.handler()
        .on(Localize.SET_POSE, this::believe)
        .on(Localize.GET_PARTICLES, none -> Optional.of(particles(bench.state()))));
  }

  private Optional<Empty> believe(Localize.Estimate there) {
    return Poses.isFinite(there.mean()) ? bench.done(new Command.InitialPose(Poses.planar(there.mean())))
        : Optional.empty();
  }

  /** The spread as a cloud, as a filter would have it. */
  private static Localize.Particles particles(RobotState state) {
    Spread spread = Spread.of(state);
    Random random = new Random(SEED);
    List<Localize.Particle> all = new ArrayList<>();
    for (int i = 0; i < PARTICLES; i++) {
      Pose2 off = new Pose2(Math.sqrt(spread.place()) * random.nextGaussian(),
          Math.sqrt(spread.place()) * random.nextGaussian(),
          Math.sqrt(spread.heading()) * random.nextGaussian());
      all.add(new Localize.Particle(Poses.of(state.estimate().times(off)), 1.0 / PARTICLES));
    }
    return new Localize.Particles(Poses.of(state.estimate()), spread.place(), all);
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    if (RATE.isDue(step)) {
      Localize.Hypothesis guess = new Localize.Hypothesis(Poses.of(state.estimate()), Spread.of(state).covariance(), 1);
      device.publish(Localize.HYPOTHESES, new Localize.Hypotheses(0, stamp, List.of(guess)), stamp);
    }
  }
}
