package org.robotui.sim.internal.nav;

import java.util.ArrayList;
import java.util.List;
import org.robotui.sim.internal.world.Pose2;

/** Takes the corners of the grid out of a path without bringing it closer to obstacles than allowed. */
final class PathSmoother {
  private static final int ROUNDS = 80;
  private static final double PULL = 0.35;

  private final Clearance clearance;
  private final double radius;

  PathSmoother(Clearance clearance, double radius) {
    this.clearance = clearance;
    this.radius = radius;
  }

  /** @param cells the way between start and goal, which replaces its last cell */
  List<Pose2> smooth(Pose2 start, Pose2 goal, List<Pose2> cells) {
    List<Pose2> points = new ArrayList<>();
    points.add(start);
    points.addAll(cells.isEmpty() ? cells : cells.subList(0, cells.size() - 1));
    points.add(goal);
    for (int round = 0; round < ROUNDS; round++) {
      for (int i = 1; i < points.size() - 1; i++) {
        points.set(i, pulled(points.get(i - 1), points.get(i), points.get(i + 1)));
      }
    }
    return withHeadings(points, goal);
  }

  private Pose2 pulled(Pose2 before, Pose2 here, Pose2 after) {
    double x = here.x() + PULL * (before.x() + after.x() - 2 * here.x());
    double y = here.y() + PULL * (before.y() + after.y() - 2 * here.y());
    double room = clearance.atPoint(x, y);
    boolean allowed = room >= radius + 0.08 || room >= clearance.atPoint(here.x(), here.y());
    return allowed ? new Pose2(x, y, 0) : here;
  }

  private static List<Pose2> withHeadings(List<Pose2> points, Pose2 goal) {
    List<Pose2> poses = new ArrayList<>();
    for (int i = 0; i < points.size() - 1; i++) {
      Pose2 here = points.get(i);
      Pose2 next = points.get(i + 1);
      poses.add(new Pose2(here.x(), here.y(), Math.atan2(next.y() - here.y(), next.x() - here.x())));
    }
    poses.add(goal);
    return poses;
  }
}
