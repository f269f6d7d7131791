package org.robotui.sim.internal.swarm;

import java.util.ArrayList;
import java.util.List;

/** A hall with round pillars, in which a swarm drives. Its corner is the origin. Immutable. */
final class Hall {
  /** Metres. */
  static final double HEIGHT = 24;
  /** What the robots see as far as this, metres. */
  static final double SIGHT = 6;

  /**
   * A pillar.
   *
   * @param x metres
   * @param y metres
   * @param radius metres
   */
  record Pillar(double x, double y, double radius) {}

  private final double width;
  private final List<Pillar> pillars;

  private Hall(double width, List<Pillar> pillars) {
    this.width = width;
    this.pillars = List.copyOf(pillars);
  }

  /** A hall with room for some robots. */
  static Hall forRobots(int robots) {
    double width = Math.max(24, 12 + robots * 0.5);
    List<Pillar> pillars = new ArrayList<>();
    for (double x = 6; x <= width - 5; x += 8) {
      pillars.add(new Pillar(x, HEIGHT / 3, 0.5));
      pillars.add(new Pillar(x, 2 * HEIGHT / 3, 0.5));
    }
    return new Hall(width, pillars);
  }

  /** Metres from the west wall to the east wall. */
  double width() {
    return width;
  }

  List<Pillar> pillars() {
    return pillars;
  }

  /** Whether a disc touches neither wall nor pillar. */
  boolean isFree(double x, double y, double radius) {
    return x >= radius && y >= radius && x <= width - radius && y <= HEIGHT - radius
        && pillars.stream().noneMatch(p -> Math.hypot(p.x() - x, p.y() - y) < p.radius() + radius);
  }

  /** How far a ray goes until it meets a wall or a pillar, metres. */
  double range(double x, double y, double angle) {
    double dx = Math.cos(angle);
    double dy = Math.sin(angle);
    double nearest = Math.min(toWall(x, dx, width), toWall(y, dy, HEIGHT));
    for (Pillar p : pillars) {
      nearest = Math.min(nearest, toDisc(p.x() - x, p.y() - y, dx, dy, p.radius()));
    }
    return nearest;
  }

  private static double toWall(double at, double step, double end) {
    if (Math.abs(step) < 1e-9) {
      return Double.POSITIVE_INFINITY;
    }
    return Math.max(0, ((step > 0 ? end : 0) - at) / step);
  }

  /** How far a ray of unit length from the origin goes until it meets a disc; infinite where it passes. */
  static double toDisc(double x, double y, double dx, double dy, double radius) {
    double along = x * dx + y * dy;
    double aside2 = x * x + y * y - along * along;
    double half2 = radius * radius - aside2;
    return along < 0 || half2 < 0 ? Double.POSITIVE_INFINITY : Math.max(0, along - Math.sqrt(half2));
  }
}
