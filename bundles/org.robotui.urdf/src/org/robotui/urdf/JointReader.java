package org.robotui.urdf;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.geometry.Vector3;
import org.robotui.urdf.internal.Numbers;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.XmlNode;

/** Reads joints. */
final class JointReader {
  private static final Vector3 ALONG_X = new Vector3(1, 0, 0);

  private JointReader() {}

  static Joint read(XmlNode node) throws Refusal {
    Joint.Type type = type(node);
    return new Joint(node.required("name"), type, node.requiredChild("parent").required("link"),
        node.requiredChild("child").required("link"),
        LinkReader.origin(node), axis(node, type), limits(node), soft(node), mimic(node));
  }

  /** Refuses one that follows what is not there, or itself in the end. */
  static void checkMimics(List<Joint> joints, Map<String, XmlNode> nodes) throws Refusal {
    Map<String, Joint> byName = new HashMap<>();
    joints.forEach(joint -> byName.put(joint.name(), joint));
    for (Joint joint : joints) {
      Joint at = joint;
      for (int steps = 0; at.mimic().isPresent(); steps++) {
        String next = at.mimic().get().joint();
        if (!byName.containsKey(next)) {
          throw nodes.get(at.name())
              .refusal("the joint '" + at.name() + "' mimics '" + next + "', but there is no such <joint>");
        }
        if (steps > joints.size() || next.equals(joint.name())) {
          throw nodes.get(joint.name())
              .refusal("the joint '" + joint.name() + "' mimics itself, by '" + at.name() + "'");
        }
        at = byName.get(next);
      }
    }
  }

  private static Joint.Type type(XmlNode node) throws Refusal {
    String word = node.required("type");
    for (Joint.Type type : Joint.Type.values()) {
      if (type.name().toLowerCase(Locale.ROOT).equals(word)) {
        return type;
      }
    }
    throw node.refusal("type=\"" + word + "\" of the joint '" + node.required("name")
        + "', must be revolute, continuous, prismatic, fixed, floating or planar");
  }

  private static Vector3 axis(XmlNode node, Joint.Type type) throws Refusal {
    Optional<XmlNode> axis = node.child("axis");
    Vector3 along = axis.isPresent() ? Numbers.vector(axis.get(), "xyz", ALONG_X) : ALONG_X;
    double length = along.norm();
    if (!(length > 0)) {
      if (type.single()) {
        throw axis.orElse(node).refusal("the axis of the joint '" + node.required("name")
            + "' has no length, must be a direction such as xyz=\"0 0 1\"");
      }
      return ALONG_X;
    }
    return along.times(1 / length);
  }

  private static Optional<Joint.Limits> limits(XmlNode node) throws Refusal {
    Optional<XmlNode> limit = node.child("limit");
    if (limit.isEmpty()) {
      return Optional.empty();
    }
    XmlNode at = limit.get();
    return Optional.of(new Joint.Limits(
        Numbers.or(at, "lower", 0), Numbers.or(at, "upper", 0), Numbers.or(at, "effort", 0),
        Numbers.or(at, "velocity", 0)));
  }

  private static Optional<Joint.SoftLimits> soft(XmlNode node) throws Refusal {
    Optional<XmlNode> safety = node.child("safety_controller");
    if (safety.isEmpty()) {
      return Optional.empty();
    }
    XmlNode at = safety.get();
    return Optional
        .of(new Joint.SoftLimits(Numbers.or(at, "soft_lower_limit", 0), Numbers.or(at, "soft_upper_limit", 0),
            Numbers.or(at, "k_position", 0), Numbers.or(at, "k_velocity", 0)));
  }

  private static Optional<Joint.Mimic> mimic(XmlNode node) throws Refusal {
    Optional<XmlNode> mimic = node.child("mimic");
    if (mimic.isEmpty()) {
      return Optional.empty();
    }
    XmlNode at = mimic.get();
    return Optional
        .of(new Joint.Mimic(at.required("joint"), Numbers.or(at, "multiplier", 1), Numbers.or(at, "offset", 0)));
  }
}
