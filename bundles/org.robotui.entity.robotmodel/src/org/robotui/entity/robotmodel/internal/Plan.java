package org.robotui.entity.robotmodel.internal;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.urdf.Joint;

/**
 * Where joints of a model shall be over time: finite numbers, times that never go back, one point at least. Not changed
 * after it was made.
 */
final class Plan {
  private final List<Joint> joints;
  private final double[] seconds;
  private final double[] positions;
  private final Map<String, Double> others;
  private final List<String> remarks;

  /**
   * Takes what was checked.
   *
   * @param joints that move, each turns or slides about one axis
   * @param seconds of the points, since the start
   * @param positions radians or metres, the joints of the first point, of the second, ...
   * @param others where joints are that do not move, by name
   * @param remarks sentences on what was left out or supposed
   */
  Plan(List<Joint> joints, double[] seconds, double[] positions, Map<String, Double> others, List<String> remarks) {
    this.joints = List.copyOf(joints);
    this.seconds = seconds.clone();
    this.positions = positions.clone();
    this.others = Map.copyOf(others);
    this.remarks = List.copyOf(remarks);
  }

  List<Joint> joints() {
    return joints;
  }

  List<String> remarks() {
    return remarks;
  }

  int points() {
    return seconds.length;
  }

  /** From the first point on, seconds. */
  double duration() {
    return seconds[seconds.length - 1];
  }

  /** Radians or metres of a joint at a point. */
  double position(int point, int joint) {
    return positions[point * joints.size() + joint];
  }

  /** All joints at a point. */
  Map<String, Double> at(int point) {
    return between(point, point, 0);
  }

  /**
   * All joints at a time, on the straight way between the points around it; before the start and after the end they
   * stand.
   */
  Map<String, Double> at(double time) {
    int found = Arrays.binarySearch(seconds, time);
    int next = found >= 0 ? found : -found - 1;
    if (next == 0 || next >= seconds.length) {
      return at(Math.min(next, seconds.length - 1));
    }
    double span = seconds[next] - seconds[next - 1];
    return between(next - 1, next, span > 0 ? (time - seconds[next - 1]) / span : 1);
  }

  private Map<String, Double> between(int from, int to, double share) {
    Map<String, Double> at = new HashMap<>(others);
    for (int joint = 0; joint < joints.size(); joint++) {
      double start = position(from, joint);
      at.put(joints.get(joint).name(), start + share * (position(to, joint) - start));
    }
    return at;
  }
}
