package org.robotui.entity.marker.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.robotui.data.marker.Marker;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.TriangleMesh;

/** Markers that are many of something themselves. */
final class Crowds {
  /** Solids of one marker; what is more is left out and said. */
  static final int MOST = 500_000;
  private static final int MANY_SPHERES = 500;

  private Crowds() {}

  static Vector3 point(Marker marker, int index) {
    return new Vector3(marker.points().get(3 * index), marker.points().get(3 * index + 1),
        marker.points().get(3 * index + 2));
  }

  /** A colour a point, where the marker has them. */
  static Optional<ByteBuffer> colors(Marker marker) {
    return marker.colors().size() == 0 ? Optional.empty() : Optional.of(marker.colors().buffer(ByteOrder.BIG_ENDIAN));
  }

  /** What all points are coloured with: nothing where they have colours. */
  static Rgba paint(Marker marker) {
    return marker.colors().size() == 0 ? Looks.color(marker) : Rgba.WHITE;
  }

  static MarkerShapes spheres(Marker marker, RigidTransform at) {
    return of(marker.points().size() / 3 > MANY_SPHERES ? Meshes.coarseSphere() : Meshes.sphere(), marker, at);
  }

  /**
   * A point that is not finite stays in the list, where nothing is drawn of it, so that elements keep their numbers.
   */
  static MarkerShapes of(TriangleMesh mesh, Marker marker, RigidTransform at) {
    int all = marker.points().size() / 3;
    int count = Math.min(all, MOST);
    FloatBuffer placings =
        ByteBuffer.allocateDirect(4 * Instances.PLACING * count).order(ByteOrder.nativeOrder()).asFloatBuffer();
    Vector3 scale = marker.scale();
    for (int i = 0; i < count; i++) {
      Vector3 p = point(marker, i);
      boolean fine = p.isFinite();
      put(placings, fine ? p : Vector3.ZERO, fine ? scale : Vector3.ZERO);
    }
    Optional<ByteBuffer> colors = colors(marker).map(c -> c.slice(0, 4 * count));
    MarkerShapes look = MarkerShapes.of(Instances.of(mesh, placings.flip(), colors), at, Material.lit(paint(marker)));
    return all > count ? look.but("only " + count + " of its " + all + " solids are shown") : zero(look, scale);
  }

  private static MarkerShapes zero(MarkerShapes look, Vector3 scale) {
    return scale.x() == 0 || scale.y() == 0 || scale.z() == 0 ? look.but("its scale is 0 along an axis") : look;
  }

  private static void put(FloatBuffer placings, Vector3 p, Vector3 scale) {
    placings.put((float) p.x()).put((float) p.y()).put((float) p.z());
    Quaternion q = Quaternion.IDENTITY;
    placings.put((float) q.x()).put((float) q.y()).put((float) q.z()).put((float) q.w());
    placings.put((float) scale.x()).put((float) scale.y()).put((float) scale.z());
  }

  static MarkerShapes triangles(Marker marker, RigidTransform at) {
    int count = marker.points().size() / 3;
    if (count == 0 || count % 3 != 0) {
      return MarkerShapes.nothing("a list of triangles needs points in threes, this one has " + count);
    }
    FloatBuffer xyz = scaled(marker);
    IntBuffer corners = ByteBuffer.allocateDirect(4 * count).order(ByteOrder.nativeOrder()).asIntBuffer();
    for (int i = 0; i < count; i++) {
      corners.put(i, i);
    }
    TriangleMesh mesh =
        new TriangleMesh(xyz, Optional.empty(), Optional.empty(), colors(marker), corners, Box3.around(xyz));
    return zero(MarkerShapes.of(mesh, at, Material.lit(paint(marker))), marker.scale());
  }

  private static FloatBuffer scaled(Marker marker) {
    int numbers = marker.points().size();
    Vector3 s = marker.scale();
    FloatBuffer xyz = ByteBuffer.allocateDirect(4 * numbers).order(ByteOrder.nativeOrder()).asFloatBuffer();
    for (int i = 0; i < numbers; i += 3) {
      xyz.put((float) (marker.points().get(i) * s.x())).put((float) (marker.points().get(i + 1) * s.y()));
      xyz.put((float) (marker.points().get(i + 2) * s.z()));
    }
    return xyz.flip();
  }
}
