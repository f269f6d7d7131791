package org.robotui.urdf;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** Where the links of a model are. Safe for all threads. */
public final class Kinematics {
  private final RobotModel model;

  /**
   * Prepares it.
   *
   * @param model the robot
   */
  public Kinematics(RobotModel model) {
    this.model = model;
  }

  /**
   * Where all links are. Joints that follow others need no position; one without, or with one that is no finite number,
   * is at 0.
   *
   * @param positions by joint, radians or metres
   * @param free where the children of floating and planar joints are in the frame of the joint, by joint; at its origin
   * where it is missing
   * @return root from link, by name of the link
   */
  public Map<String, RigidTransform> rootFromLinks(Map<String, Double> positions, Map<String, RigidTransform> free) {
    Map<String, RigidTransform> places = HashMap.newHashMap(model.links().size());
    places.put(model.root(), RigidTransform.IDENTITY);
    for (Joint joint : model.joints()) {
      places.put(joint.child(), places.get(joint.parent()).times(parentFromChild(joint, positions, free)));
    }
    return places;
  }

  /**
   * Where the child of one joint is.
   *
   * @param joint a joint of the model
   * @param positions by joint, radians or metres
   * @param free as above
   * @return parent link from child link
   */
  public RigidTransform parentFromChild(Joint joint, Map<String, Double> positions, Map<String, RigidTransform> free) {
    if (joint.type() == Joint.Type.FIXED) {
      return joint.parentFromJoint();
    }
    return joint.parentFromJoint().times(joint.type().single()
        ? moved(joint, position(joint, positions))
        : free.getOrDefault(joint.name(), RigidTransform.IDENTITY));
  }

  /**
   * Where a joint is, by its own position or by that of the one it follows.
   *
   * @param joint a joint of the model
   * @param positions by joint
   * @return radians or metres; 0 where nothing is known
   */
  public double position(Joint joint, Map<String, Double> positions) {
    Joint at = joint;
    double factor = 1;
    double offset = 0;
    while (at.mimic().isPresent()) {
      Joint.Mimic mimic = at.mimic().get();
      Optional<Joint> leader = model.joint(mimic.joint());
      if (leader.isEmpty()) {
        break;
      }
      offset += factor * mimic.offset();
      factor *= mimic.multiplier();
      at = leader.get();
    }
    double position = positions.getOrDefault(at.name(), 0.0);
    return Double.isFinite(position) ? factor * position + offset : 0;
  }

  private static RigidTransform moved(Joint joint, double position) {
    if (joint.type() == Joint.Type.PRISMATIC) {
      return new RigidTransform(joint.axis().times(position), Quaternion.IDENTITY);
    }
    Vector3 half = joint.axis().times(Math.sin(position / 2));
    return new RigidTransform(Vector3.ZERO, new Quaternion(half.x(), half.y(), half.z(), Math.cos(position / 2)));
  }
}
