package org.robotui.sim.internal.message;

import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.world.Pose2;

/** Takes places that others name into the map. For any thread. */
public record Places(Frames frames, Supplier<RobotState> robot) {
  /**
   * A place in the map, or why there is none.
   *
   * @param pose in the map; empty if it cannot be told
   * @param problem for a user; empty if there is none
   */
  public record Found(Optional<Pose2> pose, String problem) {}

  public Found inMap(String frame, Pose pose) {
    if (!Poses.isFinite(pose)) {
      return new Found(Optional.empty(), "it is not finite");
    }
    Optional<Pose2> place = inMap(frame, Poses.planar(pose));
    return new Found(place, place.isPresent() ? "" : "no transform from '" + frame + "' to '" + Frames.MAP + "'");
  }

  /** A message without a frame is taken to be in the map. */
  private Optional<Pose2> inMap(String frame, Pose2 pose) {
    String name = frame.startsWith("/") ? frame.substring(1) : frame;
    RobotState state = robot.get();
    if (name.isEmpty() || name.equals(Frames.MAP)) {
      return Optional.of(pose);
    }
    if (name.equals(frames.odometry())) {
      return Optional.of(state.mapFromOdometry().times(pose));
    }
    return name.equals(frames.base()) ? Optional.of(state.estimate().times(pose)) : Optional.empty();
  }
}
