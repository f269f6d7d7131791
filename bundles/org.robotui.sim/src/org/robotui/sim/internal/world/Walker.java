package org.robotui.sim.internal.world;

import java.util.List;

/** Somebody who walks round and round, and turns back rather than running into the robot. For one thread. */
public final class Walker {
  private static final double SPEED = 0.6;
  private static final double DISTANCE = 0.9;
  private static final double RADIUS = 0.18;
  private static final double HEIGHT = 1.72;
  private static final int TROUSERS = 0x3b4252;
  private static final int COAT = 0x5b4a8a;
  private static final int SKIN = 0xd9a98a;
  private static final int HAIR = 0x4a3527;

  private final List<Pose2> corners;
  private final double length;
  private double travelled;
  private int direction = 1;

  /** @param corners of a closed way, two or more */
  public Walker(List<Pose2> corners) {
    if (corners.size() < 2) {
      throw new IllegalArgumentException("a walk needs two corners or more");
    }
    this.corners = List.copyOf(corners);
    double sum = 0;
    for (int i = 0; i < corners.size(); i++) {
      sum += corner(i).distanceTo(corner(i + 1));
    }
    length = sum;
  }

  private Pose2 corner(int index) {
    return corners.get(index % corners.size());
  }

  /** Goes on for {@code dt} seconds. */
  public void step(Pose2 robot, double dt) {
    double next = Math.floorMod(Math.round((travelled + direction * SPEED * dt) * 1e6), Math.round(length * 1e6)) / 1e6;
    double before = place(travelled).distanceTo(robot);
    double after = place(next).distanceTo(robot);
    if (after < DISTANCE && after < before) {
      direction = -direction;
    } else {
      travelled = next;
    }
  }

  public Pose2 place() {
    return place(travelled);
  }

  private Pose2 place(double along) {
    double left = along;
    for (int i = 0; i < corners.size(); i++) {
      Pose2 from = corner(i);
      Pose2 to = corner(i + 1);
      double part = from.distanceTo(to);
      if (left < part) {
        return between(from, to, left / part);
      }
      left -= part;
    }
    return corner(0);
  }

  private static Pose2 between(Pose2 from, Pose2 to, double t) {
    double yaw = Math.atan2(to.y() - from.y(), to.x() - from.x());
    return new Pose2(from.x() + t * (to.x() - from.x()), from.y() + t * (to.y() - from.y()), yaw);
  }

  /** What cameras see of somebody at a place. */
  public static List<Solid> figure(Pose2 place) {
    return List.of(
        part(TROUSERS, place, 0.13, 0, 0.82), part(COAT, place, RADIUS, 0.82, 1.45),
        part(SKIN, place, 0.06, 1.45, 1.50), part(SKIN, place, 0.10, 1.50, 1.66),
        part(HAIR, place, 0.105, 1.66, HEIGHT));
  }

  private static Solid part(int colour, Pose2 place, double radius, double bottom, double top) {
    return Shapes.column(Solid.Kind.OBJECT, colour, place.x(), place.y(), radius, bottom, top);
  }

  /** What lasers and sonars meet of somebody at a place. */
  public static Solid body(Pose2 place) {
    return part(COAT, place, RADIUS, 0, HEIGHT);
  }
}
