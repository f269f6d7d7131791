package org.robotui.ui.scene;

import java.time.Duration;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.command.Principal;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;

/** Sends what the user points out, and says what became of it. Takes the lease where nobody has it. Never blocks. */
public final class Commander {
  private static final Duration VALID = Duration.ofSeconds(2);
  private static final double PLACE_VARIANCE = 0.25;
  private static final double HEADING_VARIANCE = Math.pow(Math.toRadians(15), 2);
  private static final int YY = 7;
  private static final int YAW_YAW = 35;

  private final Output<NavigationGoal> goals;
  private final Output<PoseEstimate> poses;
  private final Principal principal;

  /**
   * Commands through the ports of a view.
   *
   * @param context of the view
   * @param goal where the robot shall go
   * @param initialPose tells localisation where it is
   */
  public Commander(UicContext context, CommandPort<NavigationGoal> goal, CommandPort<PoseEstimate> initialPose) {
    goals = context.output(goal);
    poses = context.output(initialPose);
    principal = context.principal();
  }

  /**
   * Sends the robot somewhere.
   *
   * @param frame in which the pose is given
   * @param pose where, and where it shall look
   * @return what became of it
   */
  public CommandNotice goal(FrameId frame, RigidTransform pose) {
    return send(goals, new NavigationGoal(frame, pose), "Goal " + words(pose) + " sent");
  }

  /**
   * Tells localisation where the robot is: within half a metre and 15 degrees.
   *
   * @param frame in which the pose is given
   * @param pose where, and where it looks
   * @return what became of it
   */
  public CommandNotice initialPose(FrameId frame, RigidTransform pose) {
    return send(poses, roughly(frame, pose), "Pose " + words(pose) + " sent");
  }

  /**
   * Where the user believes a robot to be: within half a metre and 15 degrees.
   *
   * @param frame in which the pose is given
   * @param pose where, and where it looks
   * @return the estimate
   */
  public static PoseEstimate roughly(FrameId frame, RigidTransform pose) {
    double[] covariance = new double[Odometry.COVARIANCE_SIZE];
    covariance[0] = PLACE_VARIANCE;
    covariance[YY] = PLACE_VARIANCE;
    covariance[YAW_YAW] = HEADING_VARIANCE;
    return new PoseEstimate(frame, pose, Doubles.wrap(covariance));
  }

  /**
   * Sends a command of any kind.
   *
   * @param <T> the type of the command
   * @param output where to
   * @param command what
   * @param done what is said where it was taken
   * @return what became of it
   */
  public <T extends Data> CommandNotice send(Output<T> output, T command, String done) {
    if (output.state() instanceof InputState.Unconnected u) {
      return new CommandNotice(Health.BAD, "Not sent: " + u.explanation());
    }
    if (output.authority().take(principal, false) instanceof LeaseOutcome.HeldBy held) {
      return new CommandNotice(Health.BAD,
          "Not sent: " + held.holder().label() + " controls " + output.authority().robot() + "; take over first");
    }
    return switch (output.send(command, VALID)) {
      case CommandOutcome.Accepted a -> new CommandNotice(Health.OK, done);
      case CommandOutcome.Refused r -> new CommandNotice(Health.BAD, "Not sent: " + r.explanation());
    };
  }

  private static String words(RigidTransform pose) {
    return "x " + Figures.fixed(pose.translation().x(), 2) + "  y " + Figures.of(pose.translation().y(), 2, "m")
        + "  " + Figures.degrees(pose.rotation().yaw(), 0);
  }
}
