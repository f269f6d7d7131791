package org.robotui.bridge.internal;

import java.util.Optional;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.bridge.BridgeTransform;
import org.robotui.data.Data;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;

/** Where one robot is becomes the goal of another one, which follows it; the other way, goals become poses. */
@Component(service = BridgeTransform.class)
public final class PoseGoalTransform implements BridgeTransform {
  @Override
  public String id() {
    return "pose_goal";
  }

  @Override
  public String help() {
    return "Poses, odometry and estimates of poses become goals, as where one robot follows another one; on the way"
        + " back, goals become poses.";
  }

  @Override
  public Optional<Data> apply(Data value, Direction direction) {
    return Optional.of(switch (value) {
      case NavigationGoal goal when direction == Direction.BACK -> new StampedPose(goal.frame(), goal.pose());
      case StampedPose pose when direction == Direction.FORTH -> new NavigationGoal(pose.frame(), pose.pose());
      case Odometry odometry when direction == Direction.FORTH -> new NavigationGoal(odometry.frame(), odometry.pose());
      case PoseEstimate pose when direction == Direction.FORTH -> new NavigationGoal(pose.frame(), pose.pose());
      default -> throw new IllegalArgumentException("pose_goal takes "
          + (direction == Direction.FORTH ? "StampedPose, Odometry and PoseEstimate" : "NavigationGoal") + ", not "
          + value.getClass().getSimpleName());
    });
  }
}
