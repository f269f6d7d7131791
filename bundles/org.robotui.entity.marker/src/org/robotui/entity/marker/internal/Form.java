package org.robotui.entity.marker.internal;

import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.TriangleMesh;

/** The simple solids, of which many are drawn at once. */
enum Form {
  CUBE(Meshes.cube()),
  SPHERE(Meshes.sphere()),
  CYLINDER(Meshes.cylinder()),
  /** From its tip along x. */
  CONE(Meshes.cone()),
  ARROW(Meshes.arrow());

  private final TriangleMesh mesh;

  Form(TriangleMesh mesh) {
    this.mesh = mesh;
  }

  TriangleMesh mesh() {
    return mesh;
  }
}
