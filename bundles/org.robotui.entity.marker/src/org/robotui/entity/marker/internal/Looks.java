package org.robotui.entity.marker.internal;

import java.util.List;
import java.util.Optional;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.Marker;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Rgba;

/** What markers look like, and what is wrong with them. */
final class Looks {
  private static final String UNTURNED = "its orientation is all zero, taken as none";
  private static final double HEAD = 0.23;

  private Looks() {}

  static Rgba color(Marker marker) {
    Color c = marker.color();
    return new Rgba(c.red(), c.green(), c.blue(), c.alpha());
  }

  static MarkerShapes of(Marker marker) {
    RigidTransform pose = marker.pose();
    double length = pose.rotation().norm();
    if (!pose.translation().isFinite() || !Double.isFinite(length)) {
      return MarkerShapes.nothing("its pose is not finite");
    }
    if (!marker.scale().isFinite()) {
      return MarkerShapes.nothing("its scale is not finite");
    }
    boolean none = length < 1e-9;
    RigidTransform at =
        new RigidTransform(pose.translation(), none ? Quaternion.IDENTITY : pose.rotation().normalized());
    MarkerShapes look = shape(marker, at);
    return none ? look.but(UNTURNED)
        : !ownColors(marker) && color(marker).alpha() == 0 ? look.but("its alpha is 0: it is invisible") : look;
  }

  private static boolean ownColors(Marker marker) {
    return marker.colors().size() > 0 || marker.type() == Marker.Type.MESH;
  }

  private static MarkerShapes shape(Marker marker, RigidTransform at) {
    return switch (marker.type()) {
      case ARROW -> arrow(marker, at);
      case CUBE -> solid(Form.CUBE, marker, at);
      case SPHERE -> solid(Form.SPHERE, marker, at);
      case CYLINDER -> solid(Form.CYLINDER, marker, at);
      case LINE_STRIP -> Lines.of(marker, at, false);
      case LINE_LIST -> Lines.of(marker, at, true);
      case CUBE_LIST -> Crowds.of(Form.CUBE.mesh(), marker, at);
      case SPHERE_LIST -> Crowds.spheres(marker, at);
      case POINTS -> points(marker, at);
      case TEXT -> text(marker, at);
      case TRIANGLE_LIST -> Crowds.triangles(marker, at);
      case MESH -> mesh(marker, at);
      case UNKNOWN -> MarkerShapes.nothing("its type is not known");
    };
  }

  private static MarkerShapes solid(Form form, Marker marker, RigidTransform at) {
    Vector3 s = marker.scale();
    MarkerShapes look = MarkerShapes.solid(form, at, s);
    return s.x() == 0 || s.y() == 0 || s.z() == 0 ? look.but("its scale is 0 in " + zeros(s)) : look;
  }

  private static String zeros(Vector3 s) {
    List<String> axes = List.of(s.x() == 0 ? "x" : "", s.y() == 0 ? "y" : "", s.z() == 0 ? "z" : "");
    return String.join(", ", axes.stream().filter(a -> !a.isEmpty()).toList());
  }

  private static MarkerShapes arrow(Marker marker, RigidTransform at) {
    int points = marker.points().size() / 3;
    if (points == 0) {
      return solid(Form.ARROW, marker, at);
    }
    if (points != 2) {
      return MarkerShapes.nothing("an arrow has no points or two, this one " + points);
    }
    Vector3 from = at.apply(point(marker, 0));
    Vector3 to = at.apply(point(marker, 1));
    double length = to.minus(from).norm();
    if (!(length > 0) || !Double.isFinite(length)) {
      return MarkerShapes.nothing("its two points are the same or not finite");
    }
    return between(from, to, length, marker.scale());
  }

  /** Shaft and head have proportions of their own, so an arrow between points is a cylinder and a cone. */
  private static MarkerShapes between(Vector3 from, Vector3 to, double length, Vector3 scale) {
    Vector3 along = to.minus(from).times(1 / length);
    double head = scale.z() > 0 ? Math.min(scale.z(), length) : HEAD * length;
    RigidTransform shaft =
        new RigidTransform(from.plus(along.times((length - head) / 2)), Turns.between(new Vector3(0, 0, 1), along));
    RigidTransform tip = new RigidTransform(to, Turns.between(new Vector3(1, 0, 0), along.times(-1)));
    MarkerShapes look = new MarkerShapes(
        List.of(new MarkerShapes.Piece(Form.CYLINDER, shaft, new Vector3(scale.x(), scale.x(), length - head)),
            new MarkerShapes.Piece(Form.CONE, tip, new Vector3(head, scale.y(), scale.y()))),
        Optional.empty(), Optional.empty(), "");
    return scale.x() == 0 || scale.y() == 0
        ? look.but("the diameters of its shaft and head, scale x and y, must not be 0")
        : look;
  }

  private static Vector3 point(Marker marker, int index) {
    return new Vector3(marker.points().get(3 * index), marker.points().get(3 * index + 1),
        marker.points().get(3 * index + 2));
  }

  private static MarkerShapes mesh(Marker marker, RigidTransform at) {
    Vector3 s = marker.scale();
    MarkerShapes look = marker.mesh().isBlank() ? MarkerShapes.nothing("it names no mesh") : MarkerShapes.mesh(at);
    return s.x() == 0 || s.y() == 0 || s.z() == 0 ? look.but("its scale is 0 in " + zeros(s)) : look;
  }

  private static MarkerShapes points(Marker marker, RigidTransform at) {
    if (marker.scale().x() <= 0) {
      return MarkerShapes.nothing("the width of its points, scale x, must be more than 0");
    }
    PointSet set =
        PointSet.of(marker.points().buffer(), Crowds.colors(marker), (float) marker.scale().x(), PointSet.Unit.METRES);
    return MarkerShapes.of(set, at, Material.flat(Crowds.paint(marker)));
  }

  private static MarkerShapes text(Marker marker, RigidTransform at) {
    if (marker.scale().z() <= 0) {
      return MarkerShapes.nothing("the height of its letters, scale z, must be more than 0");
    }
    if (marker.text().isBlank()) {
      return MarkerShapes.nothing("its text is empty");
    }
    return MarkerShapes.of(new Label(marker.text(), (float) marker.scale().z(), PointSet.Unit.METRES), at,
        Material.flat(color(marker)));
  }
}
