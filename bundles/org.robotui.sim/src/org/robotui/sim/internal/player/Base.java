package org.robotui.sim.internal.player;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.player.interfaces.Body;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Setting;
import org.robotui.player.layout.Empty;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/**
 * {@code position2d:0}. A velocity holds for two seconds, as with a Pioneer's own watchdog, and when the last client
 * goes the robot stops.
 */
final class Base implements Part {
  private static final Rate RATE = new Rate(20);
  private static final double HOLD = 2;
  private static final long TOGETHER = 1;

  private final Bench bench;
  private final ServedDevice device;
  private final AtomicBoolean driven = new AtomicBoolean();

  Base(Bench bench) {
    this.bench = bench;
    device = bench.add("position2d", 0, bench.handler(this::clients)
        .on(Position2d.VELOCITY, command -> drive(command.velocity()))
        .on(Position2d.POSITION, command -> approach(command.position(), command.velocity()))
        .on(Position2d.GET_GEOMETRY, none -> Optional.of(geometry()))
        .on(Position2d.MOTOR_POWER, power -> bench.done(new Command.Motors(power.on())))
        .on(Position2d.VELOCITY_MODE, mode -> mode.value() == TOGETHER ? Optional.of(new Empty()) : Optional.empty())
        .on(Position2d.POSITION_MODE, this::mode)
        .on(Position2d.SET_ODOMETRY, there -> odometry(there.pose()))
        .on(Position2d.RESET_ODOMETRY, none -> odometry(Poses.of(Pose2.ORIGIN))));
  }

  private void clients(int clients) {
    if (clients == 0 && driven.getAndSet(false)) {
      bench.submit(new Command.Stop());
    }
  }

  private void drive(Pose2d velocity) {
    if (Poses.isFinite(velocity)) {
      driven.set(true);
      bench.submit(new Command.Drive(new Speed(velocity.x(), velocity.yaw()), HOLD));
    }
  }

  private void approach(Pose2d place, Pose2d velocity) {
    if (Poses.isFinite(place) && Poses.isFinite(velocity)) {
      driven.set(true);
      Speed cruise = bench.state().tuning().cruise();
      bench.submit(new Command.Approach(Poses.planar(place),
          new Speed(most(velocity.x(), cruise.linear()), most(velocity.yaw(), cruise.angular()))));
    }
  }

  /** A speed of zero leaves the choice to the robot. */
  private static double most(double wish, double otherwise) {
    return wish == 0 ? otherwise : Math.min(Math.abs(wish), otherwise);
  }

  /** Commands say themselves whether they mean velocities or places; a change of the mode ends what the robot does. */
  private Optional<Empty> mode(Setting mode) {
    return mode.value() <= 1 ? bench.done(new Command.Stop()) : Optional.empty();
  }

  private Optional<Empty> odometry(Pose2d there) {
    return Poses.isFinite(there) ? bench.done(new Command.SetOdometry(Poses.planar(there))) : Optional.empty();
  }

  private Body geometry() {
    return Poses.round(Poses.ahead(0, 0), 2 * bench.robot().model().radius(), bench.robot().model().height());
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    if (RATE.isDue(step)) {
      Pose2d velocity = new Pose2d(state.speed().linear(), 0, state.speed().angular());
      device.publish(Position2d.STATE, new Position2d.State(Poses.of(state.odometry()), velocity, state.bumped()),
          stamp);
    }
  }
}
