package org.robotui.entity.robotmodel.internal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.array.Doubles;
import org.robotui.urdf.Joint;

/** Collects the points of a plan. A joint that a part of a trajectory does not name stays where it was. */
final class Points {
  private final List<Joint> joints;
  private final Map<String, Double> start;
  private final double[] now;
  private final boolean known;
  private final List<Double> seconds = new ArrayList<>();
  private final List<double[]> positions = new ArrayList<>();

  /**
   * Without points.
   *
   * @param joints that move
   * @param start where the joints of the robot are before, as far as known
   */
  Points(List<Joint> joints, Map<String, Double> start) {
    this.joints = joints;
    this.start = start;
    now = joints.stream().mapToDouble(joint -> start.getOrDefault(joint.name(), 0.0)).toArray();
    known = joints.stream().allMatch(joint -> start.containsKey(joint.name()));
  }

  /** The first point lies after the start: the robot comes from where it is, if that is known. */
  void start() {
    if (known) {
      seconds.add(0.0);
      positions.add(joints.stream().mapToDouble(joint -> start.get(joint.name())).toArray());
    }
  }

  void move(Map<String, Integer> columns, Doubles to) {
    for (int i = 0; i < now.length; i++) {
      Integer column = columns.get(joints.get(i).name());
      now[i] = column == null ? now[i] : to.get(column);
    }
  }

  void add(double time) {
    seconds.add(time);
    positions.add(now.clone());
  }

  Plan plan(List<String> remarks) {
    Map<String, Double> others = new HashMap<>(start);
    joints.forEach(joint -> others.remove(joint.name()));
    double[] all = positions.stream().flatMapToDouble(Arrays::stream).toArray();
    return new Plan(joints, seconds.stream().mapToDouble(Double::doubleValue).toArray(), all, others, remarks);
  }
}
