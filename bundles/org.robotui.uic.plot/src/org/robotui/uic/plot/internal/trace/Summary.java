package org.robotui.uic.plot.internal.trace;

/** What some samples are together; samples that are no finite number do not count. One thread at a time. */
public final class Summary {
  private double min = Double.POSITIVE_INFINITY;
  private double max = Double.NEGATIVE_INFINITY;
  private double sum;
  private long count;

  public void clear() {
    min = Double.POSITIVE_INFINITY;
    max = Double.NEGATIVE_INFINITY;
    sum = 0;
    count = 0;
  }

  public void add(double value) {
    if (Double.isFinite(value)) {
      min = Math.min(min, value);
      max = Math.max(max, value);
      sum += value;
      count++;
    }
  }

  void add(double lowest, double highest, double total, long samples) {
    min = Math.min(min, lowest);
    max = Math.max(max, highest);
    sum += total;
    count += samples;
  }

  public void add(Summary other) {
    add(other.min, other.max, other.sum, other.count);
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

  /** NaN where there is none. */
  public double mean() {
    return count == 0 ? Double.NaN : sum / count;
  }
}
