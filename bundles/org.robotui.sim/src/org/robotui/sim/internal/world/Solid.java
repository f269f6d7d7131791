package org.robotui.sim.internal.world;

/** An upright prism over a convex polygon: everything in the building is made of these. */
public final class Solid {
  /** What a solid is, as far as the picture of it is concerned. */
  public enum Kind {
    /** Takes the wall colour of the room it is seen from. */
    WALL,
    /** Has a colour of its own. */
    OBJECT,
    /** Has a colour of its own and gives light: windows, markers. */
    GLOWING
  }

  private final double[] xs;
  private final double[] ys;
  private final double[] normalX;
  private final double[] normalY;
  private final double[] offset;
  private final double minX;
  private final double minY;
  private final double maxX;
  private final double maxY;
  private final Kind kind;
  private final int colour;
  private final double bottom;
  private final double top;

  /**
   * @param xs corner coordinates, counter-clockwise and convex, metres
   * @param ys as xs
   * @param bottom height of the underside, metres
   * @param top height of the upper side, metres
   * @param colour 0xrrggbb
   */
  public Solid(Kind kind, int colour, double bottom, double top, double[] xs, double[] ys) {
    if (xs.length < 3 || xs.length != ys.length || !(bottom < top)) {
      throw new IllegalArgumentException("a solid needs three corners or more, and bottom below top");
    }
    this.kind = kind;
    this.colour = colour;
    this.bottom = bottom;
    this.top = top;
    this.xs = xs.clone();
    this.ys = ys.clone();
    normalX = new double[xs.length];
    normalY = new double[xs.length];
    offset = new double[xs.length];
    for (int i = 0; i < xs.length; i++) {
      outwardNormal(i);
    }
    minX = min(xs);
    minY = min(ys);
    maxX = -min(negated(xs));
    maxY = -min(negated(ys));
  }

  private void outwardNormal(int i) {
    int next = (i + 1) % xs.length;
    double dx = xs[next] - xs[i];
    double dy = ys[next] - ys[i];
    double length = Math.hypot(dx, dy);
    normalX[i] = dy / length;
    normalY[i] = -dx / length;
    offset[i] = normalX[i] * xs[i] + normalY[i] * ys[i];
  }

  private static double min(double[] values) {
    double least = values[0];
    for (double value : values) {
      least = Math.min(least, value);
    }
    return least;
  }

  private static double[] negated(double[] values) {
    double[] result = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      result[i] = -values[i];
    }
    return result;
  }

  public Kind kind() {
    return kind;
  }

  public int colour() {
    return colour;
  }

  public double bottom() {
    return bottom;
  }

  public double top() {
    return top;
  }

  public double normalX(int edge) {
    return normalX[edge];
  }

  public double normalY(int edge) {
    return normalY[edge];
  }

  public boolean covers(double height) {
    return bottom <= height && height < top;
  }

  /** Clips the ray {@code origin + t * direction, t > 0}; false if it misses. */
  public boolean clip(double ox, double oy, double dx, double dy, RaySpan span) {
    double enter = Double.NEGATIVE_INFINITY;
    double exit = Double.POSITIVE_INFINITY;
    int edge = -1;
    for (int i = 0; i < normalX.length; i++) {
      double gap = offset[i] - normalX[i] * ox - normalY[i] * oy;
      double speed = normalX[i] * dx + normalY[i] * dy;
      if (speed == 0) {
        if (gap < 0) {
          return false;
        }
        continue;
      }
      double t = gap / speed;
      if (speed < 0 && t > enter) {
        enter = t;
        edge = i;
      } else if (speed > 0 && t < exit) {
        exit = t;
      }
      if (enter > exit || exit <= 0) {
        return false;
      }
    }
    span.enter = enter;
    span.exit = exit;
    span.edge = enter > 0 ? edge : -1;
    return true;
  }

  /** Distance of a point to the outline in metres, negative inside. */
  public double distance(double x, double y) {
    double inside = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < normalX.length; i++) {
      inside = Math.max(inside, normalX[i] * x + normalY[i] * y - offset[i]);
    }
    return inside <= 0 ? inside : distanceToOutline(x, y);
  }

  private double distanceToOutline(double x, double y) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < xs.length; i++) {
      int next = (i + 1) % xs.length;
      double ex = xs[next] - xs[i];
      double ey = ys[next] - ys[i];
      double t = ((x - xs[i]) * ex + (y - ys[i]) * ey) / (ex * ex + ey * ey);
      double clamped = Math.clamp(t, 0, 1);
      least = Math.min(least, Math.hypot(x - xs[i] - clamped * ex, y - ys[i] - clamped * ey));
    }
    return least;
  }

  /** Whether the point lies within the bounding box grown by a margin: a cheap test before {@link #distance}. */
  public boolean isNear(double x, double y, double margin) {
    return x > minX - margin && x < maxX + margin && y > minY - margin && y < maxY + margin;
  }
}
