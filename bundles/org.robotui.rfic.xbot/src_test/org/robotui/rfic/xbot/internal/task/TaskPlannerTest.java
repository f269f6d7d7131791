package org.robotui.rfic.xbot.internal.task;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

class TaskPlannerTest {
  private final TaskArm arm = SixJoints.arm();
  private final RigidTransform start = arm.pose(SixJoints.HAND, arm.start());

  private RigidTransform from(double x, double y, double z, Quaternion turn) {
    return new RigidTransform(start.translation().plus(new Vector3(x, y, z)), turn.times(start.rotation()));
  }

  private MotionPlan plan(FrameTask task, RigidTransform target, FrameTask... active) {
    MotionPlan plan = TaskPlanner.plan(arm, task, target, List.of(active));
    double[] before = plan.points().getFirst().positions();
    double seconds = 0;
    for (MotionPlan.Point point : plan.points().subList(1, plan.points().size())) {
      for (int i = 0; i < arm.size(); i++) {
        double now = point.positions()[i];
        assertTrue(now >= arm.lower(i) && now <= arm.upper(i), () -> "outside of its range");
        assertTrue(Math.abs(now - before[i]) <= arm.fastest(i) * (point.seconds() - seconds) + 1e-9, () -> "too fast");
      }
      before = point.positions();
      seconds = point.seconds();
    }
    return plan;
  }

  @Test
  void aTargetWithinReachIsReachedInAStraightLineWithTheSpeedOfTheTask() {
    Vector3 way = new Vector3(0.1, 0.15, 0.05);
    RigidTransform target = from(way.x(), way.y(), way.z(), Quaternion.fromYaw(0.3));

    MotionPlan plan = plan(SixJoints.HAND, target, SixJoints.HAND);

    assertTrue(plan.reaches(), () -> plan.shortfall());
    assertEquals(way.norm() / SixJoints.HAND.linear(), plan.seconds(), 0.5);
    double most = plan.points().stream().mapToDouble(point -> {
      Vector3 gone = arm.pose(SixJoints.HAND, point.positions()).translation().minus(start.translation());
      return gone.cross(way.times(1 / way.norm())).norm();
    }).max().orElseThrow();
    assertTrue(most < 3e-3, () -> "beside the line by " + most);
  }

  @Test
  void aTargetOutOfReachIsApproachedAndTheRestIsTold() {
    MotionPlan plan = plan(SixJoints.HAND, from(2, 0, 0, Quaternion.IDENTITY), SixJoints.HAND);

    assertFalse(plan.reaches());
    assertTrue(plan.metres() > 0.8 && plan.metres() < 2, () -> plan.shortfall());
    assertTrue(plan.shortfall().startsWith("out of reach by "), () -> plan.shortfall());
  }

  @Test
  void aLowerTaskLeavesAHigherOneWhereItIs() {
    FrameTask hand = new FrameTask("Arm", "hand", "hand", "base", 1, FrameTask.Phase.THERE, "111000", 0.1, 0.5);
    FrameTask wrist = new FrameTask("Arm", "wrist", "l4", "base", 2, FrameTask.Phase.THERE, "111000", 0.1, 0.5);
    RigidTransform before = arm.pose(wrist, arm.start());

    MotionPlan plan = plan(wrist, new RigidTransform(before.translation().plus(new Vector3(0, 0.1, 0)),
        before.rotation()), hand, wrist);

    double[] end = plan.points().getLast().positions();
    assertTrue(arm.pose(hand, end).translation().minus(start.translation()).norm() < 2e-3);
    assertTrue(arm.pose(wrist, end).translation().y() > before.translation().y() + 0.01);
  }

  @Test
  void anglesGiveTheSameRotationAlsoWhereThePitchIsARightAngle() {
    for (double pitch : new double[]{0.4, Math.PI / 2, -Math.PI / 2, 1.5707963, 3}) {
      Quaternion turn = Quaternion.fromRollPitchYaw(0.7, pitch, -1.1);
      double[] angles = Twists.rollPitchYaw(turn);
      double[] missed = Twists.difference(new RigidTransform(Vector3.ZERO, turn),
          new RigidTransform(Vector3.ZERO, Quaternion.fromRollPitchYaw(angles[0], angles[1], angles[2])));
      assertEquals(0, Twists.radians(missed), 1e-6, () -> "pitch " + pitch);
    }
  }
}
