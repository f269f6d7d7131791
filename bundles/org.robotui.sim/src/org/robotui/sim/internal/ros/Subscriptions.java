package org.robotui.sim.internal.ros;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.msgs.geometry_msgs.Pose;
import org.robotui.ros.msgs.geometry_msgs.PoseStamped;
import org.robotui.ros.msgs.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.ros.msgs.geometry_msgs.Twist;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Event;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/** Turns what others publish into commands. */
final class Subscriptions {
  private final Simulation simulation;
  private final Frames frames;
  private final Consumer<Event> events;

  Subscriptions(RosNode node, Simulation simulation, Frames frames, Consumer<Event> events) {
    this.simulation = simulation;
    this.frames = frames;
    this.events = events;
    SubscriberOptions options = SubscriberOptions.standard();
    node.subscriber("cmd_vel", Twist.CODEC, options, (twist, from) -> drive(twist));
    node.subscriber("move_base_simple/goal", PoseStamped.CODEC, options, (goal, from) -> goal(goal));
    node.subscriber(
        "initialpose", PoseWithCovarianceStamped.CODEC, options, (pose, from) -> initialPose(pose));
  }

  private void drive(Twist twist) {
    Speed speed = new Speed(twist.linear().x(), twist.angular().z());
    if (speed.isFinite()) {
      submit(new Command.Drive(speed));
    } else {
      warn("cmd_vel ignored: it is not finite");
    }
  }

  private void goal(PoseStamped goal) {
    submit("goal", goal.header().frameId(), goal.pose(), Command.Goal::new);
  }

  private void initialPose(PoseWithCovarianceStamped pose) {
    submit("initialpose", pose.header().frameId(), pose.pose().pose(), Command.InitialPose::new);
  }

  private void submit(String what, String frame, Pose pose, Function<Pose2, Command> command) {
    if (!Poses.isFinite(pose)) {
      warn(what + " ignored: it is not finite");
      return;
    }
    Optional<Pose2> place = inMap(frame, Poses.planar(pose));
    place.map(command).ifPresentOrElse(this::submit, () -> warn(what + " ignored: no transform from '" + frame
        + "' to '" + Frames.MAP + "'"));
  }

  /** A message without a frame is taken to be in the map. */
  private Optional<Pose2> inMap(String frame, Pose2 pose) {
    String name = frame.startsWith("/") ? frame.substring(1) : frame;
    RobotState state = simulation.state();
    if (name.isEmpty() || name.equals(Frames.MAP)) {
      return Optional.of(pose);
    }
    if (name.equals(frames.odometry())) {
      return Optional.of(state.mapFromOdometry().times(pose));
    }
    return name.equals(frames.base()) ? Optional.of(state.estimate().times(pose)) : Optional.empty();
  }

  private void submit(Command command) {
    if (!simulation.submit(command)) {
      warn("too many commands at once: one was dropped");
    }
  }

  private void warn(String text) {
    events.accept(new Event(Event.Severity.WARN, "commands", text));
  }
}
