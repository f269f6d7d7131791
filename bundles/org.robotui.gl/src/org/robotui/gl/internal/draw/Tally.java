package org.robotui.gl.internal.draw;

/** Counts what a picture shows. */
public final class Tally {
  private long points;
  private long pointsLeftOut;
  private long triangles;
  private long trianglesLeftOut;

  void points(long drawn, long leftOut) {
    points += drawn;
    pointsLeftOut += leftOut;
  }

  void triangles(long drawn, long leftOut) {
    triangles += drawn;
    trianglesLeftOut += leftOut;
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
   * Triangles that the next complete picture has.
   *
   * @return not drawn
   */
  public long trianglesLeftOut() {
    return trianglesLeftOut;
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
