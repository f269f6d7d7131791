package org.robotui.entity.marker.internal;

import java.nio.FloatBuffer;
import org.robotui.data.array.Bytes;
import org.robotui.data.marker.Marker;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Rgba;

/** Lines of markers: as wide as they say where they are wide, else two pixels, so that they are always seen. */
final class Lines {
  private static final double WIDE = 0.02;
  private static final int MOST_WIDE = 20_000;
  private static final float PIXELS = 2;

  private Lines() {}

  static MarkerShapes of(Marker marker, RigidTransform at, boolean pairs) {
    int points = marker.points().size() / 3;
    if (points < 2 || pairs && points % 2 != 0) {
      return MarkerShapes.nothing(pairs ? "a list of lines needs pairs of points, this one has " + points
          : "a line needs two points, this one has " + points);
    }
    if (marker.scale().x() <= 0) {
      return MarkerShapes.nothing("the width of its lines, scale x, must be more than 0");
    }
    return marker.scale().x() >= WIDE && points <= MOST_WIDE ? wide(marker, at, pairs) : thin(marker, at, pairs);
  }

  private static MarkerShapes thin(Marker marker, RigidTransform at, boolean pairs) {
    FloatBuffer xyz = marker.points().buffer();
    LineSet.Kind kind = pairs ? LineSet.Kind.SEGMENTS : LineSet.Kind.STRIP;
    return MarkerShapes.of(new LineSet(xyz, Crowds.colors(marker), kind, PIXELS, Box3.around(xyz)), at,
        Material.flat(Crowds.paint(marker)));
  }

  /** A bar each, coloured by its first point. */
  private static MarkerShapes wide(Marker marker, RigidTransform at, boolean pairs) {
    int points = marker.points().size() / 3;
    Placings bars = new Placings(points);
    double width = marker.scale().x();
    for (int i = 0; i + 1 < points; i += pairs ? 2 : 1) {
      Vector3 from = Crowds.point(marker, i);
      Vector3 span = Crowds.point(marker, i + 1).minus(from);
      double length = span.norm();
      if (length > 0 && Double.isFinite(length)) {
        RigidTransform middle =
            new RigidTransform(from.plus(span.times(0.5)), Turns.between(new Vector3(1, 0, 0), span.times(1 / length)));
        bars.add(middle, new Vector3(length, width, width), color(marker, i));
      }
    }
    return MarkerShapes.of(bars.of(Meshes.cube()), at, Material.flat(Rgba.WHITE));
  }

  private static Rgba color(Marker marker, int index) {
    Bytes c = marker.colors();
    return c.size() == 0 ? Looks.color(marker)
        : new Rgba(part(c, 4 * index), part(c, 4 * index + 1), part(c, 4 * index + 2), part(c, 4 * index + 3));
  }

  private static float part(Bytes colors, int index) {
    return colors.unsigned(index) / 255f;
  }
}
