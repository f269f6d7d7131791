package org.robotui.sim.internal.world;

import org.robotui.sim.internal.world.Solid.Kind;

/** Makes the solids that a floor plan speaks of. */
public final class Shapes {
  private static final int COLUMN_SIDES = 20;

  private Shapes() {}

  public static Solid box(int colour, double x1, double y1, double x2, double y2, double height) {
    double[] xs = {Math.min(x1, x2), Math.max(x1, x2), Math.max(x1, x2), Math.min(x1, x2)};
    double[] ys = {Math.min(y1, y2), Math.min(y1, y2), Math.max(y1, y2), Math.max(y1, y2)};
    return new Solid(Kind.OBJECT, colour, 0, height, xs, ys);
  }

  public static Solid column(Kind kind, int colour, double x, double y, double radius, double bottom, double top) {
    double[] xs = new double[COLUMN_SIDES];
    double[] ys = new double[COLUMN_SIDES];
    for (int i = 0; i < COLUMN_SIDES; i++) {
      double angle = 2 * Math.PI * i / COLUMN_SIDES;
      xs[i] = x + radius * Math.cos(angle);
      ys[i] = y + radius * Math.sin(angle);
    }
    return new Solid(kind, colour, bottom, top, xs, ys);
  }

  /** A slab of the given thickness around a centre line. */
  public static Solid slab(Kind kind, int colour, Line line, double thickness, double bottom, double top) {
    double ux = (line.x2() - line.x1()) / line.length() * thickness / 2;
    double uy = (line.y2() - line.y1()) / line.length() * thickness / 2;
    double[] xs = {line.x1() + uy, line.x2() + uy, line.x2() - uy, line.x1() - uy};
    double[] ys = {line.y1() - ux, line.y2() - ux, line.y2() + ux, line.y1() + ux};
    return new Solid(kind, colour, bottom, top, xs, ys);
  }
}
