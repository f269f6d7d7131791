package org.robotui.uic.plot.internal.signal;

/**
 * The mean of the samples of the last seconds. A break begins it anew. What it keeps is bounded: of samples that come
 * faster than that, the newest count.
 */
final class AverageNode implements Sink {
  static final int MOST = 1 << 18;

  private static final int RENEWED_EVERY = 1 << 12;

  private final Sink out;
  private final long window;
  private final SampleQueue kept = new SampleQueue();
  private double sum;
  private int sinceRenewed;

  AverageNode(double seconds, Sink out) {
    this.window = Math.round(seconds * 1e9);
    this.out = out;
  }

  @Override
  public void accept(long time, double value) {
    if (Double.isNaN(value)) {
      kept.clear();
      sum = 0;
      out.accept(time, Double.NaN);
      return;
    }
    kept.add(time, value);
    sum += value;
    // However short the window, and whatever the times are, the newest value stays.
    while (kept.size() > 1 && (kept.time(0) <= time - window || kept.size() > MOST)) {
      sum -= kept.value(0);
      kept.remove();
    }
    renew();
    out.accept(time, sum / kept.size());
  }

  /** Rounding adds up, and an infinite value would stay for ever: the sum is taken anew from time to time. */
  private void renew() {
    if (++sinceRenewed < RENEWED_EVERY && Double.isFinite(sum)) {
      return;
    }
    sinceRenewed = 0;
    sum = 0;
    for (int i = 0; i < kept.size(); i++) {
      sum += kept.value(i);
    }
  }
}
