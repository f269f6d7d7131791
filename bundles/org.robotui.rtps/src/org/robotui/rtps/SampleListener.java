package org.robotui.rtps;

/** Hears of samples. */
@FunctionalInterface
public interface SampleListener {

  /**
   * A sample came. Called on the one thread with which the participant receives, for the samples of each writer in
   * their order, and without a lock: it may write, and open and close readers and writers, but it must not block, as
   * all readers of the participant wait for it. What it throws is logged and counted.
   *
   * @param sample may be kept
   */
  void received(Sample sample);
}
