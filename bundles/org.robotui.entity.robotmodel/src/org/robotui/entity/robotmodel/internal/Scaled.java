package org.robotui.entity.robotmodel.internal;

import java.nio.FloatBuffer;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.TriangleMesh;

/** Meshes made larger or smaller along their axes. */
final class Scaled {
  private Scaled() {}

  static TriangleMesh by(TriangleMesh mesh, Vector3 scale) {
    FloatBuffer xyz = places(mesh.xyz(), scale);
    return new TriangleMesh(xyz, mesh.normals().map(normals -> normals(normals, scale)), mesh.uv(), mesh.rgba(),
        mesh.triangles(), Box3.around(xyz));
  }

  static FloatBuffer places(FloatBuffer from, Vector3 scale) {
    FloatBuffer xyz = FloatBuffer.allocate(from.remaining());
    for (int i = from.position(); i + 2 < from.limit(); i += 3) {
      xyz.put((float) (from.get(i) * scale.x())).put((float) (from.get(i + 1) * scale.y()))
          .put((float) (from.get(i + 2) * scale.z()));
    }
    return xyz.flip();
  }

  /** Normals turn the other way than places: what is stretched is flatter. */
  static FloatBuffer normals(FloatBuffer from, Vector3 scale) {
    FloatBuffer normals = FloatBuffer.allocate(from.remaining());
    Vector3 by = new Vector3(scale.y() * scale.z(), scale.x() * scale.z(), scale.x() * scale.y());
    double sign = scale.x() * scale.y() * scale.z() < 0 ? -1 : 1;
    for (int i = from.position(); i + 2 < from.limit(); i += 3) {
      Vector3 normal =
          new Vector3(from.get(i) * by.x() * sign, from.get(i + 1) * by.y() * sign, from.get(i + 2) * by.z() * sign);
      double length = normal.norm();
      Vector3 unit = length > 0 ? normal.times(1 / length) : new Vector3(0, 0, 1);
      normals.put((float) unit.x()).put((float) unit.y()).put((float) unit.z());
    }
    return normals.flip();
  }
}
