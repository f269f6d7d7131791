package org.robotui.uic.plot.internal.trace;

/** What some samples are together; samples that are no finite number do not count. One thread at a time. */
public final class Summary {
  private double min = Double.POSITIVE_INFINITY;
  private double max = Double.NEGATIVE_INFINITY;
  private double sum;
  /** Of the distances from the mean. */
  private double squares;
  private long count;

  public void clear() {
    min = Double.POSITIVE_INFINITY;
    max = Double.NEGATIVE_INFINITY;
    sum = 0;
    squares = 0;
    count = 0;
  }

  public void add(double value) {
    if (Double.isFinite(value)) {
      min = Math.min(min, value);
      max = Math.max(max, value);
      double before = count == 0 ? value : mean();
      sum += value;
      count++;
      squares += (value - before) * (value - mean());
    }
  }

  /** Two groups together have the squares of both, and those of the distance between their means. */
  void add(double lowest, double highest, double total, double distances, long samples) {
    if (count > 0 && samples > 0) {
      double apart = total / samples - mean();
      squares += apart * apart * count * samples / (count + samples);
    }
    squares += distances;
    min = Math.min(min, lowest);
    max = Math.max(max, highest);
    sum += total;
    count += samples;
  }

  public void add(Summary other) {
    add(other.min, other.max, other.sum, other.squares, other.count);
  }

  public boolean isEmpty() {
    return count == 0;
  }

  public long count() {
    return count;
  }

  /** The smallest; +inf where there is none. */
  public double min() {
    return min;
  }

  /** The largest; -inf where there is none. */
  public double max() {
    return max;
  }

  double sum() {
    return sum;
  }

  /** Of the distances from the mean. */
  double squares() {
    return squares;
  }

  /** NaN where there is none. */
  public double mean() {
    return count == 0 ? Double.NaN : sum / count;
  }

  /** The standard deviation, divided by the count; NaN where there is none. */
  public double deviation() {
    return count == 0 ? Double.NaN : Math.sqrt(Math.max(0, squares) / count);
  }
}
