package org.robotui.rfic.xbot.internal.task;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.data.array.Doubles;
import org.robotui.data.joint.DisplayedTrajectory;
import org.robotui.data.joint.JointTrajectory;
import org.robotui.geometry.RigidTransform;

/**
 * How joints are expected to go when a frame is sent to a pose.
 *
 * @param joints their names
 * @param points where they are, with the time
 * @param end where the frame comes to, in the frame of its base
 * @param metres by which it misses its target
 * @param radians by which it misses its target
 * @param limit a joint that is at its limit at the end
 */
record MotionPlan(List<String> joints, List<Point> points, RigidTransform end, double metres, double radians,
    Optional<String> limit) {
  /** As near as a motion comes where nothing holds it back, with some room for steps of the plan. */
  private static final double NEAR_METRES = 5e-3;
  private static final double NEAR_RADIANS = 2e-2;

  /** Where the joints are at a time. */
  record Point(double seconds, double[] positions) {}

  /** Copies the lists. */
  MotionPlan {
    joints = List.copyOf(joints);
    points = List.copyOf(points);
  }

  boolean reaches() {
    return metres < NEAR_METRES && radians < NEAR_RADIANS;
  }

  double seconds() {
    return points.getLast().seconds();
  }

  /** What is wrong with a target that is not reached. */
  String shortfall() {
    String far = String.format(Locale.ROOT, "out of reach by %.3f m and %.2f rad", metres, radians);
    return limit.map(joint -> far + ": " + joint + " is at its limit").orElse(far);
  }

  /** As displays of trajectories take it. */
  DisplayedTrajectory displayed(String model) {
    JointTrajectory way = new JointTrajectory(joints,
        points.stream().map(point -> new JointTrajectory.Point(point.seconds(), Doubles.of(point.positions()),
            Doubles.EMPTY, Doubles.EMPTY, Doubles.EMPTY)).toList());
    return new DisplayedTrajectory(model, List.of(), List.of(way));
  }

  /** Nothing is planned. */
  static DisplayedTrajectory none(String model) {
    return new DisplayedTrajectory(model, List.of(), List.of());
  }
}
