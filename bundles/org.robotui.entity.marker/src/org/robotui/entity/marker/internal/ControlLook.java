package org.robotui.entity.marker.internal;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.marker.InteractiveMarker.Control;
import org.robotui.data.marker.InteractiveMarker.Mode;
import org.robotui.data.marker.Marker;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Shape;
import org.robotui.gl.shape.TriangleMesh;

/**
 * The shapes of a control: those that the robot gives it, or, so that it can be gripped, the usual ones for its mode.
 * Made once for each control.
 */
final class ControlLook {
  private static final double INNER = 0.5;
  private static final double OUTER = 0.62;
  private static final int AROUND = 48;

  private ControlLook() {}

  /**
   * A shape of a control.
   *
   * @param shape what is drawn
   * @param at marker, or the frame, from shape
   * @param material how it looks
   * @param frame in which it is placed, where it is not the marker
   */
  record Piece(Shape shape, RigidTransform at, Material material, Optional<FrameId> frame) {}

  static List<Piece> of(Control control, double scale) {
    List<Piece> given = given(control.markers());
    return given.isEmpty() ? usual(control, scale) : given;
  }

  private static List<Piece> given(List<Marker> markers) {
    List<Piece> pieces = new ArrayList<>();
    for (Marker marker : markers) {
      MarkerShapes look = Looks.of(marker);
      Optional<FrameId> frame = marker.frame().name().isEmpty() ? Optional.empty() : Optional.of(marker.frame());
      Material paint = Material.lit(Looks.color(marker));
      look.pieces().forEach(p -> pieces.add(new Piece(one(p), RigidTransform.IDENTITY, paint, frame)));
      look.own().ifPresent(own -> pieces.add(new Piece(own.shape(), own.at(), own.material(), frame)));
    }
    return pieces;
  }

  private static Shape one(MarkerShapes.Piece piece) {
    return new Placings(1).add(piece.at(), piece.scale()).of(piece.form().mesh());
  }

  private static List<Piece> usual(Control control, double scale) {
    Quaternion turn = rotation(control);
    RigidTransform at = new RigidTransform(Vector3.ZERO, turn);
    Material paint = Material.lit(color(turn));
    Shape shape = switch (control.mode()) {
      case MOVE_AXIS -> arrows(scale);
      case MOVE_PLANE, ROTATE_AXIS, MOVE_ROTATE -> ring(scale);
      default -> ball(scale);
    };
    return control.mode() == Mode.NONE ? List.of() : List.of(new Piece(shape, at, paint, Optional.empty()));
  }

  static Quaternion rotation(Control control) {
    double length = control.rotation().norm();
    return Double.isFinite(length) && length > 1e-9 ? control.rotation().normalized() : Quaternion.IDENTITY;
  }

  /** Red along x, green along y, blue along z, mixed between. */
  private static Rgba color(Quaternion turn) {
    Vector3 axis = turn.rotate(new Vector3(1, 0, 0));
    float least = 0.25f;
    float share = 1 - least;
    return new Rgba(least + share * (float) Math.abs(axis.x()), least + share * (float) Math.abs(axis.y()),
        least + share * (float) Math.abs(axis.z()), 1);
  }

  private static Shape arrows(double scale) {
    Vector3 size = new Vector3(0.4 * scale, 0.08 * scale, 0.08 * scale);
    RigidTransform ahead = new RigidTransform(new Vector3(INNER * scale, 0, 0), Quaternion.IDENTITY);
    RigidTransform behind = new RigidTransform(new Vector3(-INNER * scale, 0, 0), Quaternion.fromYaw(Math.PI));
    return new Placings(2).add(ahead, size).add(behind, size).of(Meshes.arrow());
  }

  private static Shape ball(double scale) {
    double size = 0.25 * scale;
    return new Placings(1).add(RigidTransform.IDENTITY, new Vector3(size, size, size)).of(Meshes.sphere());
  }

  /** Flat, in the y-z plane. */
  private static Shape ring(double scale) {
    FloatBuffer xyz = FloatBuffer.allocate(6 * AROUND);
    IntBuffer corners = IntBuffer.allocate(6 * AROUND);
    for (int i = 0; i < AROUND; i++) {
      double angle = 2 * Math.PI * i / AROUND;
      for (double radius : new double[]{INNER * scale, OUTER * scale}) {
        xyz.put(0).put((float) (radius * Math.cos(angle))).put((float) (radius * Math.sin(angle)));
      }
      int next = 2 * ((i + 1) % AROUND);
      corners.put(2 * i).put(2 * i + 1).put(next).put(next).put(2 * i + 1).put(next + 1);
    }
    return TriangleMesh.of(xyz.flip(), Optional.empty(), corners.flip());
  }
}
