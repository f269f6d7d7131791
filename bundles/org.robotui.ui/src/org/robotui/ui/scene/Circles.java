package org.robotui.ui.scene;

import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.Path;

/**
 * Circles as polygons of so many corners that nobody sees it: they are filled in a quarter of the time that the
 * toolkit's arcs take.
 */
final class Circles {
  /** How far an edge may lie within the circle, pixels. */
  private static final double SAGITTA = 0.04;
  private static final int FEWEST = 8;
  private static final int MOST = 1000;

  private Circles() {}

  /** The area of a circle; to be disposed. */
  static Path disc(Device device, double x, double y, double radius) {
    Path path = new Path(device);
    add(path, x, y, radius, 1);
    return path;
  }

  /**
   * The line of a circle as an area: the inner circle goes the other way round, and is left out whatever the rule of
   * filling; to be disposed.
   */
  static Path ring(Device device, double x, double y, double radius, double width) {
    Path path = disc(device, x, y, radius + width / 2);
    if (radius > width / 2) {
      add(path, x, y, radius - width / 2, -1);
    }
    return path;
  }

  private static void add(Path path, double x, double y, double radius, int turn) {
    int corners = corners(radius);
    double[] xy = new double[2 * corners];
    for (int i = 0; i < corners; i++) {
      double angle = turn * 2 * Math.PI * i / corners;
      xy[2 * i] = x + radius * Math.cos(angle);
      xy[2 * i + 1] = y + radius * Math.sin(angle);
    }
    ClippedPath.addArea(path, xy);
  }

  static int corners(double radius) {
    double half = Math.acos(Math.max(-1, 1 - SAGITTA / Math.max(SAGITTA, radius)));
    return (int) Math.clamp(Math.ceil(Math.PI / half), FEWEST, MOST);
  }
}
