package org.robotui.urdf;

import org.robotui.geometry.Vector3;

/** A form of a link, in its own frame. */
public sealed interface Geometry {
  /**
   * A box, its middle at the origin.
   *
   * @param size edges along x, y, z; metres
   */
  record Box(Vector3 size) implements Geometry {}

  /**
   * A cylinder along z, its middle at the origin.
   *
   * @param radius metres
   * @param length metres
   */
  record Cylinder(double radius, double length) implements Geometry {}

  /**
   * A sphere around the origin.
   *
   * @param radius metres
   */
  record Sphere(double radius) implements Geometry {}

  /**
   * What a file holds.
   *
   * @param uri {@code package://...} or {@code file://...}, as written
   * @param scale along x, y, z
   */
  record MeshFile(String uri, Vector3 scale) implements Geometry {}
}
