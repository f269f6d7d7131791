package org.robotui.sim.internal.ros2;

import java.util.List;
import java.util.Map;
import org.robotui.message.DynamicMessage;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalWorker;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.message.Frames;
import org.robotui.sim.internal.message.Poses;
import org.robotui.sim.internal.world.Pose2;

/** The parts of {@code nav2_msgs/NavigateToPose}. */
final class NavigateMessages {
  static final String BUSY = "too many commands at once";
  /** {@code UNKNOWN} of the result. */
  private static final int ERROR = 9000;
  private static final double NANOS = 1e9;

  private NavigateMessages() {}

  /** Where a goal leads. */
  static Pose pose(DynamicMessage goal) {
    return new Pose(
        new Point(number(goal, "position.x"), number(goal, "position.y"), number(goal, "position.z")),
        new Quaternion(number(goal, "orientation.x"), number(goal, "orientation.y"), number(goal, "orientation.z"),
            number(goal, "orientation.w")));
  }

  private static double number(DynamicMessage goal, String path) {
    return goal.number("pose.pose." + path).orElse(Double.NaN);
  }

  static Ros2GoalWorker.End ended(Ros2GoalEnd end) {
    return new Ros2GoalWorker.End(end, Map.of());
  }

  /** @param reason for a user */
  static Ros2GoalWorker.End aborted(String reason) {
    return new Ros2GoalWorker.End(Ros2GoalEnd.ABORTED, Map.of("error_code", ERROR, "error_msg", reason));
  }

  /**
   * How far the robot got.
   *
   * @param now the time of the stamp, nanoseconds
   * @param taken since the goal was taken, nanoseconds
   */
  static Map<String, ?> feedback(RobotState state, long now, long taken) {
    Pose2 place = state.estimate();
    double left = left(place, state.path());
    Pose pose = Poses.pose(place);
    Map<String, ?> at = Map.of(
        "position", Map.of("x", pose.position().x(), "y", pose.position().y()),
        "orientation", Map.of("z", pose.orientation().z(), "w", pose.orientation().w()));
    return Map.of(
        "current_pose", Map.of("header", Map.of("stamp", now, "frame_id", Frames.MAP), "pose", at),
        "navigation_time", taken,
        "estimated_time_remaining", Math.round(left / state.tuning().cruise().linear() * NANOS),
        "distance_remaining", left);
  }

  /** The way along the rest of a path, from its place next to the robot. */
  private static double left(Pose2 place, List<Pose2> path) {
    double left = 0;
    double nearest = Double.POSITIVE_INFINITY;
    double rest = 0;
    for (int i = path.size() - 1; i >= 0; i--) {
      left += i + 1 < path.size() ? path.get(i).distanceTo(path.get(i + 1)) : 0;
      double distance = path.get(i).distanceTo(place);
      if (distance < nearest) {
        nearest = distance;
        rest = left + distance;
      }
    }
    return rest;
  }
}
