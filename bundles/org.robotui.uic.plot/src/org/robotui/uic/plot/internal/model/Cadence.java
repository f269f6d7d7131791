package org.robotui.uic.plot.internal.model;

/** Tells whether the samples of a source come as they use to, or whether it was silent in between. One thread. */
final class Cadence {
  private static final double UNUSUAL = 5;
  private static final double WEIGHT = 0.1;
  private static final int LEARNING = 4;

  private final double longest;
  private double usual;
  private int seen;

  /** Silence is never shorter than so many seconds; 0 where nothing is ever taken for silence. */
  Cadence(double longest) {
    this.longest = longest * 1e9;
  }

  /** Takes the time since the sample before; true where the source was silent. */
  boolean silent(long nanos) {
    boolean silent = longest > 0 && nanos > longest && seen >= LEARNING && nanos > UNUSUAL * usual;
    if (!silent) {
      usual = seen == 0 ? nanos : usual + WEIGHT * (nanos - usual);
      seen++;
    }
    return silent;
  }
}
