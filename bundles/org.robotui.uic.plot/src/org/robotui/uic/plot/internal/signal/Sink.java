package org.robotui.uic.plot.internal.signal;

/** Takes samples in the order of time. One thread. */
@FunctionalInterface
public interface Sink {
  /**
   * Takes a sample.
   *
   * @param time nanoseconds, not before that of the call before
   * @param value NaN says that what came before and what comes after do not belong together
   */
  void accept(long time, double value);
}
