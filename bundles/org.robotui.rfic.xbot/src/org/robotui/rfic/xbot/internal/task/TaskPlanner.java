package org.robotui.rfic.xbot.internal.task;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.geometry.RigidTransform;

/**
 * Says beforehand how joints go when one frame is sent to a pose: straight, within the ranges and velocities of the
 * joints, while the other tasks hold theirs. One plan each.
 */
final class TaskPlanner {
  private static final double STEP_SECONDS = 0.04;
  private static final double MOST_STEPS = 400;
  private static final int MOST_SETTLING = 75;
  private static final double BEHIND_METRES = 0.05;
  private static final double BEHIND_RADIANS = 0.2;
  private static final double STILL = 1e-5;

  private final TaskArm arm;
  private final FrameTask task;
  private final RigidTransform target;
  private final Map<Integer, List<FrameTask>> levels = new TreeMap<>();
  private final Map<FrameTask, RigidTransform> wanted;
  private double[] at;

  private TaskPlanner(TaskArm arm, FrameTask task, RigidTransform target, List<FrameTask> active) {
    this.arm = arm;
    this.task = task;
    this.target = target;
    this.at = arm.start();
    this.wanted = new HashMap<>();
    for (FrameTask each : active) {
      levels.computeIfAbsent(each.priority(), p -> new ArrayList<>()).add(each);
      wanted.put(each, arm.pose(each, at));
    }
  }

  /**
   * Plans.
   *
   * @param arm the joints, where they are
   * @param task what is sent
   * @param target where, in the frame of its base
   * @param active all tasks that are active, this one among them; their links are known to the arm
   */
  static MotionPlan plan(TaskArm arm, FrameTask task, RigidTransform target, List<FrameTask> active) {
    return new TaskPlanner(arm, task, target, active).plan();
  }

  private MotionPlan plan() {
    RigidTransform from = arm.pose(task, at);
    double[] way = masked(task, Twists.difference(from, target));
    double duration = Math.max(Twists.metres(way) / task.linear(), Twists.radians(way) / task.angular());
    double period = Math.max(STEP_SECONDS, duration / MOST_STEPS);
    List<MotionPlan.Point> points = new ArrayList<>(List.of(new MotionPlan.Point(0, at.clone())));
    double part = 0;
    int settling = 0;
    Optional<String> limit = Optional.empty();
    while (settling < MOST_SETTLING && points.size() < 2 * MOST_STEPS) {
      part = isBehind() ? part : Math.min(1, part + period / Math.max(duration, period));
      wanted.put(task, from.interpolate(target, part));
      double[] before = at;
      limit = step(period);
      points.add(new MotionPlan.Point(points.size() * period, at.clone()));
      boolean still = farthest(before, at) < STILL;
      settling += part >= 1 || still ? 1 : 0;
      if (still && (part >= 1 || settling > 1)) {
        break;
      }
    }
    double[] missed = masked(task, Twists.difference(arm.pose(task, at), target));
    return new MotionPlan(arm.names(), points, arm.pose(task, at), Twists.metres(missed), Twists.radians(missed),
        limit);
  }

  private boolean isBehind() {
    double[] behind = masked(task, Twists.difference(arm.pose(task, at), wanted.get(task)));
    return Twists.metres(behind) > BEHIND_METRES || Twists.radians(behind) > BEHIND_RADIANS;
  }

  private static double farthest(double[] from, double[] to) {
    double most = 0;
    for (int i = 0; i < from.length; i++) {
      most = Math.max(most, Math.abs(to[i] - from[i]));
    }
    return most;
  }

  /** Joints that would leave their range stay, and the others do what they can: one that stays, if any. */
  private Optional<String> step(double period) {
    boolean[] held = new boolean[arm.size()];
    Optional<String> first = Optional.empty();
    double[] step = solve(held);
    for (int left = arm.size(); left > 0; left--) {
      int out = outside(step, held);
      if (out < 0) {
        break;
      }
      held[out] = true;
      first = first.or(() -> Optional.of(arm.names().get(out)));
      step = solve(held);
    }
    double part = 1;
    for (int i = 0; i < step.length; i++) {
      part = Math.min(part, arm.fastest(i) * period / Math.max(Math.abs(step[i]), Double.MIN_NORMAL));
    }
    at = at.clone();
    for (int i = 0; i < step.length; i++) {
      at[i] = Math.clamp(at[i] + part * step[i], arm.lower(i), arm.upper(i));
    }
    return first;
  }

  private int outside(double[] step, boolean[] held) {
    for (int i = 0; i < step.length; i++) {
      double next = at[i] + step[i];
      if (!held[i] && (next < arm.lower(i) || next > arm.upper(i))) {
        return i;
      }
    }
    return -1;
  }

  private double[] solve(boolean[] held) {
    TaskLevels solver = new TaskLevels(arm.size(), held);
    for (List<FrameTask> level : levels.values()) {
      List<double[]> rows = new ArrayList<>();
      List<Double> changes = new ArrayList<>();
      level.forEach(each -> put(each, rows, changes));
      solver.solve(rows.toArray(double[][]::new), changes.stream().mapToDouble(Double::doubleValue).toArray());
    }
    return solver.step();
  }

  private void put(FrameTask each, List<double[]> rows, List<Double> changes) {
    double[][] slopes = arm.slopes(each, at);
    double[] difference = Twists.difference(arm.pose(each, at), wanted.get(each));
    for (int axis = 0; axis < Twists.SIZE; axis++) {
      if (each.has(axis)) {
        double[] row = new double[slopes.length];
        for (int i = 0; i < row.length; i++) {
          row[i] = slopes[i][axis];
        }
        rows.add(row);
        changes.add(difference[axis]);
      }
    }
  }

  private static double[] masked(FrameTask task, double[] twist) {
    for (int axis = 0; axis < Twists.SIZE; axis++) {
      twist[axis] = task.has(axis) ? twist[axis] : 0;
    }
    return twist;
  }
}
