package org.robotui.rfic.xbot.internal.task;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.geometry.RigidTransform;
import org.robotui.urdf.Joint;
import org.robotui.urdf.Kinematics;
import org.robotui.urdf.RobotModel;

/** The joints that a plan moves, in the model of their robot, and where frames are with them. */
final class TaskArm {
  private static final double DIFFERENCE = 1e-6;

  private final RobotModel model;
  private final Kinematics kinematics;
  private final Map<String, Double> others;
  private final List<Joint> joints;

  /**
   * With some joints of a model.
   *
   * @param model the robot
   * @param moved the names of the joints that move; those that the model does not have are left out
   * @param positions where all joints are
   */
  TaskArm(RobotModel model, List<String> moved, Map<String, Double> positions) {
    this.model = model;
    this.kinematics = new Kinematics(model);
    this.others = positions;
    this.joints =
        moved.stream().flatMap(name -> model.joint(name).stream()).filter(joint -> joint.type().single()).toList();
  }

  List<String> names() {
    return joints.stream().map(Joint::name).toList();
  }

  int size() {
    return joints.size();
  }

  double[] start() {
    return joints.stream()
        .mapToDouble(joint -> Math.clamp(others.getOrDefault(joint.name(), 0.0), lower(joint), upper(joint))).toArray();
  }

  double lower(int i) {
    return lower(joints.get(i));
  }

  double upper(int i) {
    return upper(joints.get(i));
  }

  /** rad/s or m/s; 0 in the model is no limit. */
  double fastest(int i) {
    return joints.get(i).limits().map(Joint.Limits::velocity).filter(v -> v > 0).orElse(Double.POSITIVE_INFINITY);
  }

  private static Optional<Joint.Limits> bounds(Joint joint) {
    return joint.limits().filter(l -> joint.type() != Joint.Type.CONTINUOUS && l.lower() < l.upper());
  }

  private static double lower(Joint joint) {
    return bounds(joint).map(Joint.Limits::lower).orElse(Double.NEGATIVE_INFINITY);
  }

  private static double upper(Joint joint) {
    return bounds(joint).map(Joint.Limits::upper).orElse(Double.POSITIVE_INFINITY);
  }

  boolean knows(FrameTask task) {
    return model.link(task.link()).isPresent() && model.link(task.base()).isPresent();
  }

  /** Where the frame of a task is, in that of its base. */
  RigidTransform pose(FrameTask task, double[] at) {
    Map<String, Double> positions = new HashMap<>(others);
    for (int i = 0; i < joints.size(); i++) {
      positions.put(joints.get(i).name(), at[i]);
    }
    return fromRoot(task.base(), positions).inverse().times(fromRoot(task.link(), positions));
  }

  private RigidTransform fromRoot(String link, Map<String, Double> positions) {
    List<Joint> up = new ArrayList<>();
    for (Optional<Joint> joint = model.carrier(link); joint.isPresent(); joint = model.carrier(joint.get().parent())) {
      up.add(joint.get());
    }
    RigidTransform pose = RigidTransform.IDENTITY;
    for (Joint joint : up.reversed()) {
      pose = pose.times(kinematics.parentFromChild(joint, positions, Map.of()));
    }
    return pose;
  }

  /** How the pose of a task changes with each joint: a column of {@link Twists} each. */
  double[][] slopes(FrameTask task, double[] at) {
    RigidTransform here = pose(task, at);
    double[][] columns = new double[joints.size()][];
    for (int i = 0; i < columns.length; i++) {
      double[] beside = at.clone();
      beside[i] += DIFFERENCE;
      double[] column = Twists.difference(here, pose(task, beside));
      for (int row = 0; row < column.length; row++) {
        column[row] /= DIFFERENCE;
      }
      columns[i] = column;
    }
    return columns;
  }
}
