package org.robotui.bridge.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.bridge.BridgeTransform.Direction;
import org.robotui.data.FrameId;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.geometry.RigidTransform;

class PoseGoalTransformTest {
  private static final FrameId MAP = new FrameId("Keira", "map");
  private static final StampedPose POSE = new StampedPose(MAP, RigidTransform.IDENTITY);
  private static final NavigationGoal GOAL = new NavigationGoal(MAP, RigidTransform.IDENTITY);

  private final PoseGoalTransform transform = new PoseGoalTransform();

  @Test
  void itGoesBothWays() {
    assertEquals(Optional.of(GOAL), transform.apply(POSE, Direction.FORTH));
    assertEquals(Optional.of(POSE), transform.apply(GOAL, Direction.BACK));
  }

  @Test
  void whatItDoesNotTakeIsNamed() {
    String reason = assertThrows(IllegalArgumentException.class,
        () -> transform.apply(VelocityCommand.ZERO, Direction.FORTH)).getMessage();
    assertEquals("pose_goal takes StampedPose, Odometry and PoseEstimate, not VelocityCommand", reason);
  }
}
