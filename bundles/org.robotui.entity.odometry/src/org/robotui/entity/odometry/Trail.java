package org.robotui.entity.odometry;

import org.robotui.ui.scene.PositionHistory;

/** Where a robot has been, as far back as its length. Not safe for several threads. */
final class Trail {
  private static final double FINEST = 0.02;

  private final PositionHistory way;

  Trail(int capacity) {
    way = new PositionHistory(capacity, FINEST, PositionHistory.Moves.NOTHING);
  }

  void add(double x, double y) {
    if (Double.isFinite(x) && Double.isFinite(y) && !way.near(x, y)) {
      way.add(x, y);
    }
  }

  /** Forgets the oldest part beyond a length, metres. */
  void cut(double length) {
    way.cut(length);
  }

  void clear() {
    way.clear();
  }

  int count() {
    return way.count();
  }

  /** A copy: x and y in turn. */
  double[] points() {
    return way.points();
  }
}
