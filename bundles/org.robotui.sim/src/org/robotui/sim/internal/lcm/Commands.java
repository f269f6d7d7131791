package org.robotui.sim.internal.lcm;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/** Turns what others send into commands. */
final class Commands {
  private final SimulatedRobot robot;
  private final Channels channels;
  private final AtomicLong unnamed = new AtomicLong();

  Commands(SimulatedRobot robot, Channels channels) {
    this.robot = robot;
    this.channels = channels;
    channels.listen("VELOCITY", "velocity_t", this::drive);
    channels.listen("GOAL", "goal_t", this::go);
    channels.listen("CANCEL", "cancel_t", this::cancel);
    channels.listen("INITIAL_POSE", "pose_t", this::believe);
    channels.listen("MOTORS", "motors_t", message -> submit(new Command.Motors(number(message, "on") != 0)));
  }

  private static double number(LcmRecord record, String path) {
    return record.number(path).orElse(Double.NaN);
  }

  private void drive(LcmRecord message) {
    Speed speed = new Speed(number(message, "linear[0]"), number(message, "angular[2]"));
    if (speed.isFinite()) {
      submit(new Command.Drive(speed));
    } else {
      channels.tell("a velocity was ignored: it is not finite");
    }
  }

  private void go(LcmRecord message) {
    String id = message.text("id").filter(text -> !text.isEmpty()).orElseGet(() -> "lcm-" + unnamed.incrementAndGet());
    place(message, "pose.").ifPresentOrElse(place -> submit(new Command.Goal(id, place)),
        () -> ignored("goal", message, "pose."));
  }

  private void cancel(LcmRecord message) {
    String id = message.text("id").orElse("");
    submit(id.isEmpty() ? new Command.Stop() : new Command.Cancel(id));
  }

  private void believe(LcmRecord message) {
    place(message, "").ifPresentOrElse(place -> submit(new Command.InitialPose(place)),
        () -> ignored("initial pose", message, ""));
  }

  private void ignored(String what, LcmRecord message, String path) {
    channels
        .tell("a " + what + " was ignored: it is not finite, or its frame '" + message.text(path + "frame").orElse("")
            + "' is neither map nor odom nor base");
  }

  /** Into the map; a pose without a frame is taken to be there. */
  private Optional<Pose2> place(LcmRecord message, String path) {
    double[] turn = IntStream.range(0, 4).mapToDouble(i -> number(message, path + "orientation[" + i + "]")).toArray();
    double yaw =
        Math.atan2(2 * (turn[0] * turn[3] + turn[1] * turn[2]), 1 - 2 * (turn[2] * turn[2] + turn[3] * turn[3]));
    Pose2 pose = new Pose2(number(message, path + "position[0]"), number(message, path + "position[1]"), yaw);
    if (!Double.isFinite(pose.x() + pose.y() + yaw)) {
      return Optional.empty();
    }
    RobotState state = robot.state();
    return switch (message.text(path + "frame").orElse("")) {
      case "", LcmRecords.MAP -> Optional.of(pose);
      case LcmRecords.ODOMETRY -> Optional.of(state.mapFromOdometry().times(pose));
      case LcmRecords.BASE -> Optional.of(state.estimate().times(pose));
      default -> Optional.empty();
    };
  }

  private void submit(Command command) {
    if (!robot.simulation().submit(command)) {
      channels.tell("too many commands at once: one was dropped");
    }
  }
}
