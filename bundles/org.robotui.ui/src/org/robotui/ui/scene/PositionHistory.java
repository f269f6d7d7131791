package org.robotui.ui.scene;

import java.util.Arrays;

/**
 * Where something has been: positions at least a little apart, of bounded number. When it is full, every second
 * position goes and the least distance doubles, so that a long way stays whole. Not safe for several threads.
 */
public final class PositionHistory {
  /** Is told where a position has gone, so that what belongs to it can follow. */
  @FunctionalInterface
  public interface Moves {
    /** Nothing belongs to the positions. */
    Moves NOTHING = (from, to, count) -> {};

    /**
     * Positions have gone to other indices; called in the order in which that can be done in place.
     *
     * @param from index of the first
     * @param to where the first is now, less than {@code from} or equal
     * @param count how many
     */
    void moved(int from, int to, int count);
  }

  private final double finest;
  private final Moves moves;
  private final double[] xy;
  private int count;
  private double apart;

  /**
   * Without positions.
   *
   * @param capacity how many at most, at least 2
   * @param finest how far they are apart at least, metres
   * @param moves is told which positions have other indices
   */
  public PositionHistory(int capacity, double finest, Moves moves) {
    this.finest = finest;
    this.moves = moves;
    this.xy = new double[2 * capacity];
    this.apart = finest;
  }

  /**
   * How many positions there are.
   *
   * @return the number
   */
  public int count() {
    return count;
  }

  /**
   * Whether a position is no further from the newest than positions are apart.
   *
   * @param x metres
   * @param y metres
   * @return false where there is none
   */
  public boolean near(double x, double y) {
    return count > 0 && Math.hypot(x - xy[2 * count - 2], y - xy[2 * count - 1]) < apart;
  }

  /**
   * Adds a position, near or not.
   *
   * @param x metres
   * @param y metres
   * @return its index, the last
   */
  public int add(double x, double y) {
    if (2 * count == xy.length) {
      thin();
    }
    set(count, x, y);
    return count++;
  }

  /**
   * Puts a position elsewhere.
   *
   * @param index which
   * @param x metres
   * @param y metres
   */
  public void set(int index, double x, double y) {
    xy[2 * index] = x;
    xy[2 * index + 1] = y;
  }

  /**
   * How far a position is from the one before.
   *
   * @param index which, not the first
   * @return metres
   */
  public double step(int index) {
    return Math.hypot(xy[2 * index] - xy[2 * index - 2], xy[2 * index + 1] - xy[2 * index - 1]);
  }

  /**
   * Forgets the oldest.
   *
   * @param oldest how many
   */
  public void forget(int oldest) {
    if (oldest > 0) {
      move(oldest, 0, count - oldest);
      count -= oldest;
    }
  }

  /**
   * Forgets the oldest part beyond a length.
   *
   * @param length of the way that stays, metres
   */
  public void cut(double length) {
    double kept = 0;
    int first = count - 1;
    while (first > 0 && kept < length) {
      kept += step(first);
      first--;
    }
    forget(first);
  }

  /**
   * Keeps the first positions only.
   *
   * @param first how many
   */
  public void keep(int first) {
    count = first;
  }

  /** Forgets all, and how far they had to be apart. */
  public void clear() {
    count = 0;
    apart = finest;
  }

  /**
   * All positions.
   *
   * @return x and y in turn; a copy
   */
  public double[] points() {
    return Arrays.copyOf(xy, 2 * count);
  }

  private void thin() {
    int kept = 0;
    for (int i = 0; i < count; i += 2) {
      move(i, kept++, 1);
    }
    count = kept;
    apart *= 2;
  }

  private void move(int from, int to, int many) {
    System.arraycopy(xy, 2 * from, xy, 2 * to, 2 * many);
    moves.moved(from, to, many);
  }
}
