package org.robotui.uic.scene3d.internal.render;

import org.robotui.gl.render.Rendered;

/** How many points may be drawn while the camera moves, so that it stays fluid: learned from what pictures cost. */
final class Budget {
  /** What a picture may cost while the camera moves: the hand shall see its answer within 50 ms, on the screen. */
  static final double TARGET_SECONDS = 0.02;

  /** Fewer would show nothing. */
  static final int LEAST = 20_000;

  /** What may be drawn where nothing as large was drawn yet: what software manages in time. */
  static final int UNTRIED = 500_000;

  private static final double TOO_SLOW = 1.15;
  private static final double IDLE = 0.75;
  private static final double FASTEST_GROWTH = 2;

  private int points = UNTRIED;

  int points() {
    return points;
  }

  void learn(Rendered.Figures figures) {
    double drawn = Math.max(1, figures.points());
    double possible = TARGET_SECONDS / Math.max(1e-4, figures.seconds());
    // A complete picture, of points that lie one after the other, costs less a point: it may lower what is drawn in a
    // hurry, not raise it.
    if (figures.seconds() > TARGET_SECONDS * TOO_SLOW && drawn > LEAST) {
      points = Math.min(points, bounded(drawn * possible));
    } else if (figures.seconds() < TARGET_SECONDS * IDLE && figures.pointsLeftOut() > 0) {
      points = bounded(drawn * Math.min(FASTEST_GROWTH, possible));
    } else if (figures.pointsLeftOut() == 0 && figures.seconds() < TARGET_SECONDS * IDLE) {
      points = bounded(Math.max(UNTRIED, drawn * possible));
    }
  }

  private static int bounded(double wanted) {
    return (int) Math.clamp(wanted, LEAST, Integer.MAX_VALUE);
  }
}
