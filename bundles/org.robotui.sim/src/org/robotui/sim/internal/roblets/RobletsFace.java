package org.robotui.sim.internal.roblets;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.ThreadFactory;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletSpeech;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.RecordMessage;
import org.robotui.roblets.wire.RobletForm;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.roblets.BoatMessages.Charge;
import org.robotui.sim.internal.roblets.BoatMessages.Heading;
import org.robotui.sim.internal.roblets.BoatMessages.Motion;
import org.robotui.sim.internal.roblets.BoatMessages.Place;
import org.robotui.sim.internal.roblets.BoatMessages.Velocity;

/** A robot on wheels as roblets: two of its own, and those that the boat has as well. */
public final class RobletsFace implements Face {
  private static final double HOLD = 0.5;

  private final int port;
  private final ThreadFactory threads;
  private Optional<SimulatedBody> body = Optional.empty();

  /** @param port where the brain listens; 0 for a free one */
  public RobletsFace(int port, ThreadFactory threads) {
    this.port = port;
    this.threads = threads;
  }

  @Override
  public void show(SimulatedRobot robot, long stamp) throws IOException {
    SimulatedBody opened = new SimulatedBody(robot.model().name(), port, threads);
    body = Optional.of(opened);
    opened.run(() -> new BaseRoblet(robot));
    opened.run(() -> new SayingRoblet<>("localization", 5, Place.class, () -> place(robot.state())));
    opened.run(() -> CommonRoblets.compass(() -> heading(robot.state())));
    opened.run(() -> CommonRoblets.battery(() -> charge(robot.state())));
    opened.run(CommonRoblets.HeartRoblet::new);
  }

  private static Place place(RobotState state) {
    return new Place(state.estimate().x(), state.estimate().y(), state.estimate().yaw());
  }

  private static Heading heading(RobotState state) {
    double degrees = 90 - Math.toDegrees(state.truth().yaw());
    return new Heading((degrees % 360 + 360) % 360, -Math.toDegrees(state.speed().angular()));
  }

  private static Charge charge(RobotState state) {
    return new Charge(state.battery().voltage(), state.battery().current(), state.battery().level());
  }

  /** Says how it moves, and is driven. */
  private static final class BaseRoblet implements Roblet {
    private static final RecordMessage<Velocity> VELOCITY = RecordMessage.of(Velocity.class);

    private final SimulatedRobot robot;

    BaseRoblet(SimulatedRobot robot) {
      this.robot = robot;
    }

    @Override
    public RobletForm form() {
      return new RobletForm("base", 20, List.of(RecordMessage.of(Motion.class).form()), List.of(VELOCITY.form()),
          List.of());
    }

    @Override
    public void run(RobletSpeech speech) {
      RobotState state = robot.state();
      speech.say(new Motion(state.odometry().x(), state.odometry().y(), state.odometry().yaw(),
          state.speed().linear(), 0, state.speed().angular()));
    }

    @Override
    public void receive(String from, BodyElement message, RobletSpeech speech) {
      Velocity velocity = VELOCITY.record(message);
      Speed speed = new Speed(velocity.vx(), velocity.wz());
      if (speed.isFinite()) {
        robot.simulation().submit(new Command.Drive(speed, HOLD));
      }
    }
  }

  @Override
  public void step(long step, long stamp) {
    // roblets have a time of their own
  }

  @Override
  public SequencedMap<String, String> addresses() {
    SequencedMap<String, String> variables = new LinkedHashMap<>();
    body.ifPresent(listening -> variables.put("ROBLETS_BRAIN", listening.address()));
    return variables;
  }

  @Override
  public void close() {
    body.ifPresent(SimulatedBody::close);
  }
}
