package org.robotui.rfic.xbot.internal;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.joint.JointState;
import org.robotui.urdf.Joint;
import org.robotui.urdf.Kinematics;
import org.robotui.urdf.RobotModel;
import org.robotui.urdf.Urdf;

/** The frames of a robot's links, from its URDF and its joints: a control says no transforms itself. */
final class ModelFrames {
  static final String AUTHORITY = "the control's URDF and joints";

  private final String robot;
  private final List<Joint> joints;
  private final Optional<Kinematics> kinematics;

  /** Of a robot whose URDF cannot be read there are no frames; who shows the model says why. */
  ModelFrames(String robot, String urdf) {
    this.robot = robot;
    Optional<RobotModel> model = urdf.isBlank() ? Optional.empty() : Urdf.parse(urdf).found();
    this.joints = model.map(RobotModel::joints).orElse(List.of());
    this.kinematics = model.map(Kinematics::new);
  }

  /**
   * Where a sensor measures: XBot names a force-torque sensor by the joint in which it sits, an inertial one by its
   * link.
   */
  FrameId sensor(String name) {
    return frame(joints.stream().filter(joint -> joint.name().equals(name)).findFirst().map(Joint::child).orElse(name));
  }

  /** What never moves. */
  TransformSet fixed(Stamp stamp) {
    return transforms(true, Map.of(), stamp);
  }

  /** What moves, where its joints are now; a joint that the control does not have is at 0. */
  TransformSet moving(JointState state, Stamp stamp) {
    Map<String, Double> positions = HashMap.newHashMap(state.joints().size());
    state.joints().forEach(joint -> positions.put(joint.name(), joint.position()));
    return transforms(false, positions, stamp);
  }

  private TransformSet transforms(boolean fixed, Map<String, Double> positions, Stamp stamp) {
    return new TransformSet(kinematics.stream()
        .flatMap(known -> joints.stream().filter(joint -> fixed == (joint.type() == Joint.Type.FIXED))
            .map(joint -> new FrameTransform(frame(joint.parent()), frame(joint.child()), stamp,
                known.parentFromChild(joint, positions, Map.of()), fixed)))
        .toList());
  }

  private FrameId frame(String link) {
    return new FrameId(robot, link);
  }
}
