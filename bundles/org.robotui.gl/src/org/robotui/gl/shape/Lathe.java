package org.robotui.gl.shape;

/** Turns round bodies about an axis. */
final class Lathe {
  private final MeshBuilder mesh = new MeshBuilder();
  private final int around;

  /** The axis that is turned about. */
  enum Along {
    X,
    Y,
    Z
  }

  Lathe(int around) {
    this.around = around;
  }

  Lathe color(Rgba color) {
    mesh.color(color);
    return this;
  }

  /** The side of a cylinder or cone, from a radius at one place of the axis to a radius at a greater one. */
  Lathe tube(Along axis, double from, double fromRadius, double to, double toRadius) {
    double lean = (fromRadius - toRadius) / (to - from);
    int[] first = new int[around + 1];
    int[] last = new int[around + 1];
    for (int i = 0; i <= around; i++) {
      double angle = 2 * Math.PI * i / around;
      first[i] = corner(axis, from, fromRadius, angle, lean, 1);
      last[i] = corner(axis, to, toRadius, angle, lean, 1);
    }
    for (int i = 0; i < around; i++) {
      side(first[i], first[i + 1], last[i + 1], last[i], fromRadius, toRadius);
    }
    return this;
  }

  /** A lid that looks along the axis (1) or against it (-1). */
  Lathe disc(Along axis, double at, double radius, int facing) {
    int middle = corner(axis, at, 0, 0, facing, 0);
    int before = corner(axis, at, radius, 0, facing, 0);
    for (int i = 1; i <= around; i++) {
      int next = corner(axis, at, radius, 2 * Math.PI * i / around, facing, 0);
      mesh.triangle(middle, facing > 0 ? before : next, facing > 0 ? next : before);
      before = next;
    }
    return this;
  }

  TriangleMesh build() {
    return mesh.build();
  }

  /** Two triangles, or the one that is left where an end is a tip. */
  private void side(int a, int b, int c, int d, double fromRadius, double toRadius) {
    if (fromRadius > 0) {
      mesh.triangle(a, b, toRadius > 0 ? c : d);
    }
    if (toRadius > 0) {
      mesh.triangle(a, c, d);
    }
  }

  /** A corner, with a normal of so much along the axis and so much away from it. */
  private int corner(Along axis, double at, double radius, double angle, double along, double away) {
    double cos = Math.cos(angle);
    double sin = Math.sin(angle);
    double u = radius * cos;
    double v = radius * sin;
    return switch (axis) {
      case X -> mesh.corner(at, u, v, along, away * cos, away * sin);
      case Y -> mesh.corner(v, at, u, away * sin, along, away * cos);
      case Z -> mesh.corner(u, v, at, away * cos, away * sin, along);
    };
  }
}
