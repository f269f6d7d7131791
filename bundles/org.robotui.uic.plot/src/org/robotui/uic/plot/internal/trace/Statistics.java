package org.robotui.uic.plot.internal.trace;

/**
 * What the samples of a span are together; those that are no finite number do not count.
 *
 * @param count how many
 * @param min the smallest; NaN where there is none
 * @param max the largest; NaN where there is none
 * @param mean NaN where there is none
 * @param deviation the standard deviation, of the samples as they are (divided by their count); NaN where there is none
 * @param rate how many a second, from the first to the last; NaN where that cannot be told
 */
public record Statistics(long count, double min, double max, double mean, double deviation, double rate) {
  static Statistics of(Summary all, long nanos) {
    boolean none = all.isEmpty();
    return new Statistics(all.count(), none ? Double.NaN : all.min(), none ? Double.NaN : all.max(), all.mean(),
        all.deviation(),
        nanos > 0 && all.count() > 1 ? (all.count() - 1) * (double) TimeSpan.SECOND / nanos : Double.NaN);
  }
}
