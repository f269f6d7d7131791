package org.robotui.urdf;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.urdf.internal.Numbers;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.XmlNode;

/** Reads links. */
final class LinkReader {
  private static final Vector3 ONE = new Vector3(1, 1, 1);

  private final UrdfSurfaces surfaces;

  LinkReader(UrdfSurfaces surfaces) {
    this.surfaces = surfaces;
  }

  Link read(XmlNode node) throws Refusal {
    List<Visual> visuals = new ArrayList<>();
    for (XmlNode visual : node.children("visual")) {
      Optional<XmlNode> material = visual.child("material");
      visuals.add(new Visual(visual.attribute("name").orElse(""), origin(visual), geometry(visual),
          material.isPresent() ? Optional.of(surfaces.local(material.get())) : Optional.empty()));
    }
    List<Collision> collisions = new ArrayList<>();
    for (XmlNode collision : node.children("collision")) {
      collisions.add(new Collision(collision.attribute("name").orElse(""), origin(collision), geometry(collision)));
    }
    Optional<XmlNode> inertial = node.child("inertial");
    return new Link(node.required("name"),
        inertial.isPresent() ? Optional.of(inertial(inertial.get())) : Optional.empty(), visuals, collisions);
  }

  /** The {@code origin} of an element, where it lies if there is none. */
  static RigidTransform origin(XmlNode node) throws Refusal {
    Optional<XmlNode> origin = node.child("origin");
    if (origin.isEmpty()) {
      return RigidTransform.IDENTITY;
    }
    Vector3 turns = Numbers.vector(origin.get(), "rpy", Vector3.ZERO);
    return new RigidTransform(
        Numbers.vector(origin.get(), "xyz", Vector3.ZERO),
        Quaternion.fromRollPitchYaw(turns.x(), turns.y(), turns.z()));
  }

  private static Inertial inertial(XmlNode node) throws Refusal {
    XmlNode mass = node.requiredChild("mass");
    XmlNode moments = node.requiredChild("inertia");
    return new Inertial(origin(node), notNegative(mass, "value"), Numbers.of(moments, "ixx"),
        Numbers.of(moments, "iyy"),
        Numbers.of(moments, "izz"), Numbers.or(moments, "ixy", 0), Numbers.or(moments, "ixz", 0),
        Numbers.or(moments, "iyz", 0));
  }

  private static Geometry geometry(XmlNode node) throws Refusal {
    XmlNode geometry = node.requiredChild("geometry");
    for (XmlNode form : geometry.children()) {
      switch (form.name()) {
        case "box" -> {
          return new Geometry.Box(notNegative(form, Numbers.vector(form, "size")));
        }
        case "cylinder" -> {
          return new Geometry.Cylinder(notNegative(form, "radius"), notNegative(form, "length"));
        }
        case "sphere" -> {
          return new Geometry.Sphere(notNegative(form, "radius"));
        }
        case "mesh" -> {
          return new Geometry.MeshFile(form.required("filename"), Numbers.vector(form, "scale", ONE));
        }
        default -> {}
      }
    }
    throw geometry.refusal("<geometry> has no form, must have one of <box>, <cylinder>, <sphere>, <mesh>");
  }

  private static Vector3 notNegative(XmlNode node, Vector3 size) throws Refusal {
    if (size.x() < 0 || size.y() < 0 || size.z() < 0) {
      throw node
          .refusal("size=\"" + node.attribute("size").orElse("") + "\" is negative, must be three lengths in metres");
    }
    return size;
  }

  private static double notNegative(XmlNode node, String attribute) throws Refusal {
    double number = Numbers.of(node, attribute);
    if (number < 0) {
      throw node.refusal(attribute + "=\"" + number + "\" in <" + node.name() + "> is negative");
    }
    return number;
  }
}
