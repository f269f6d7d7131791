package org.robotui.uic.plot.internal.trace;

/**
 * One storey of the pyramid over a chunk: what each run of {@code width} samples is together. A run is put in when it
 * is whole.
 */
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
  }

  int width() {
    return width;
  }

  /**
   * Puts in the run that ends before an index, from the samples themselves. Going through them twice needs no division
   * for each.
   */
  void put(int end, double[] samples) {
    int numbers = 0;
    double lowest = Double.POSITIVE_INFINITY;
    double highest = Double.NEGATIVE_INFINITY;
    double total = 0;
    for (int i = end - width; i < end; i++) {
      double value = samples[i];
      if (Double.isFinite(value)) {
        numbers++;
        lowest = Math.min(lowest, value);
        highest = Math.max(highest, value);
        total += value;
      }
    }
    double mean = total / numbers;
    double distances = 0;
    for (int i = end - width; i < end; i++) {
      double apart = samples[i] - mean;
      distances += Double.isFinite(samples[i]) ? apart * apart : 0;
    }
    set(end / width - 1, lowest, highest, total, distances, numbers);
  }

  /** Puts in the run that ends before an index, from a finer storey that has all of it. */
  void put(int end, Level finer) {
    Summary all = new Summary();
    for (int at = end - width; at < end; at += finer.width) {
      finer.into(at / finer.width, all);
    }
    set(end / width - 1, all.min(), all.max(), all.sum(), all.squares(), Math.toIntExact(all.count()));
  }

  private void set(int bucket, double lowest, double highest, double total, double distances, int samples) {
    min[bucket] = lowest;
    max[bucket] = highest;
    sum[bucket] = total;
    squares[bucket] = distances;
    count[bucket] = samples;
  }

  void into(int bucket, Summary summary) {
    summary.add(min[bucket], max[bucket], sum[bucket], squares[bucket], count[bucket]);
  }
}
