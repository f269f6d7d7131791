package org.robotui.gl.internal.draw;

/** Counts what a picture shows. */
public final class Tally {
  private long points;
  private long pointsLeftOut;
  private long triangles;

  void points(long drawn, long leftOut) {
    points += drawn;
    pointsLeftOut += leftOut;
  }

  void triangles(long drawn) {
    triangles += drawn;
  }

  /**
   * Points.
   *
   * @return drawn
   */
  public long points() {
    return points;
  }

  /**
   * Points by which clouds were thinned.
   *
   * @return not drawn
   */
  public long pointsLeftOut() {
    return pointsLeftOut;
  }

  /**
   * Triangles.
   *
   * @return drawn
   */
  public long triangles() {
    return triangles;
  }
}
