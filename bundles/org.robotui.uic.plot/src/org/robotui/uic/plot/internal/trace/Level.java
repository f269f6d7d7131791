package org.robotui.uic.plot.internal.trace;

import java.util.Arrays;

/** One storey of the pyramid over a chunk: what each run of {@code width} samples is together. */
final class Level {
  private final int width;
  private final double[] min;
  private final double[] max;
  private final double[] sum;
  private final double[] squares;
  private final int[] count;

  Level(int samples, int width) {
    this.width = width;
    int buckets = samples / width;
    min = new double[buckets];
    max = new double[buckets];
    sum = new double[buckets];
    squares = new double[buckets];
    count = new int[buckets];
    Arrays.fill(min, Double.POSITIVE_INFINITY);
    Arrays.fill(max, Double.NEGATIVE_INFINITY);
  }

  int width() {
    return width;
  }

  void add(int index, double value) {
    if (Double.isFinite(value)) {
      int bucket = index / width;
      min[bucket] = Math.min(min[bucket], value);
      max[bucket] = Math.max(max[bucket], value);
      double before = count[bucket] == 0 ? value : sum[bucket] / count[bucket];
      sum[bucket] += value;
      count[bucket]++;
      squares[bucket] += (value - before) * (value - sum[bucket] / count[bucket]);
    }
  }

  void into(int bucket, Summary summary) {
    summary.add(min[bucket], max[bucket], sum[bucket], squares[bucket], count[bucket]);
  }
}
