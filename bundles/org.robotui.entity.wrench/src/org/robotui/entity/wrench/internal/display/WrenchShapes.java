package org.robotui.entity.wrench.internal.display;

import java.util.Optional;
import org.robotui.data.geometry.Wrench;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.TriangleMesh;

/**
 * What is drawn of a value, in its frame.
 *
 * @param force an arrow, none where it is too short
 * @param torque an arrow along its axis
 * @param ring turns as the torque does
 * @param cut what is longer than it is drawn, empty where nothing is
 */
record WrenchShapes(Optional<Solid> force, Optional<Solid> torque, Optional<LineSet> ring, String cut) {
  /**
   * What shapes depend on beside the value.
   *
   * @param force metres a newton
   * @param torque metres a newton metre
   * @param width metres
   * @param longest metres
   */
  record Scale(double force, double torque, double width, double longest) {}

  /**
   * An arrow along x.
   *
   * @param mesh its surface
   * @param turn where it points
   */
  record Solid(TriangleMesh mesh, RigidTransform turn) {}

  private static final double THINNEST = 8;
  private static final double HEAD = 4;
  private static final double HEAD_WIDE = 3;
  private static final int SEGMENTS = 24;
  private static final double TURN = 1.6 * Math.PI;
  private static final double RADIUS = 0.3;
  private static final double AT = 0.6;
  private static final double BARB = 0.25;
  private static final float PIXELS = 2;

  static WrenchShapes of(Wrench wrench, Scale scale) {
    Arrow force = Arrow.of(wrench.force(), scale.force(), scale.longest());
    Arrow torque = Arrow.of(wrench.torque(), scale.torque(), scale.longest());
    String cut = force.cut() ? "the force" : "";
    return new WrenchShapes(arrow(force, scale), arrow(torque, scale),
        torque.seen() ? Optional.of(ring(torque)) : Optional.empty(),
        torque.cut() ? (cut.isEmpty() ? "the torque" : "force and torque") : cut);
  }

  /** A short one is thinner, so that its head is still one. */
  private static Optional<Solid> arrow(Arrow arrow, Scale scale) {
    double width = Math.min(scale.width(), arrow.length() / THINNEST);
    double head = HEAD * width;
    return arrow.seen()
        ? Optional.of(new Solid(Meshes.arrow(arrow.length() - head, width, head, HEAD_WIDE * width), arrow.turn()))
        : Optional.empty();
  }

  /** An open ring around the axis, with a barb at its end. */
  private static LineSet ring(Arrow torque) {
    double radius = RADIUS * torque.length();
    float[] xyz = new float[3 * (SEGMENTS + 3)];
    for (int i = 0; i <= SEGMENTS; i++) {
      put(xyz, i, torque.turn(), on(torque.length(), radius, TURN * i / SEGMENTS));
    }
    double end = TURN - BARB;
    put(xyz, SEGMENTS + 1, torque.turn(), on(torque.length(), radius * (1 - BARB), end));
    put(xyz, SEGMENTS + 2, torque.turn(), on(torque.length(), radius, TURN));
    return LineSet.of(LineSet.Kind.STRIP, PIXELS, xyz);
  }

  private static Vector3 on(double length, double radius, double angle) {
    return new Vector3(AT * length, radius * Math.cos(angle), radius * Math.sin(angle));
  }

  private static void put(float[] xyz, int corner, RigidTransform turn, Vector3 point) {
    Vector3 at = turn.apply(point);
    xyz[3 * corner] = (float) at.x();
    xyz[3 * corner + 1] = (float) at.y();
    xyz[3 * corner + 2] = (float) at.z();
  }
}
