package org.robotui.uic.plot.internal.signal;

/** Takes the samples of two signals that lie at the same times, in their order. One thread. */
@FunctionalInterface
public interface PairSink {
  /**
   * Takes a sample of each.
   *
   * @param time nanoseconds, not before that of the call before
   * @param x NaN breaks the curve, here and as the other
   * @param y the one whose times these are
   */
  void accept(long time, double x, double y);
}
