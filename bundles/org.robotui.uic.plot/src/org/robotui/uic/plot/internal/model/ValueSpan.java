package org.robotui.uic.plot.internal.model;

/** The values that a scale shows. */
public record ValueSpan(double low, double high) {
  public ValueSpan {
    if (!(low < high) || !Double.isFinite(high - low)) {
      throw new IllegalArgumentException("no span of values: " + low + " to " + high);
    }
  }

  public double length() {
    return high - low;
  }

  public ValueSpan moved(double by) {
    return orSame(low + by, high + by);
  }

  /** Scales the length and leaves one value where it is on the screen. */
  public ValueSpan zoomed(double factor, double fixed) {
    return orSame(fixed - (fixed - low) * factor, fixed + (high - fixed) * factor);
  }

  /** As long as wanted, with the same middle. */
  public ValueSpan lengthened(double length) {
    double middle = low + length() / 2;
    return orSame(middle - length / 2, middle + length / 2);
  }

  /** What numbers cannot tell apart is not zoomed into. */
  private ValueSpan orSame(double nextLow, double nextHigh) {
    double finest = Math.ulp(Math.max(Math.abs(nextLow), Math.abs(nextHigh))) * 1e3;
    boolean good = nextHigh - nextLow > finest && Double.isFinite(nextHigh - nextLow);
    return good ? new ValueSpan(nextLow, nextHigh) : this;
  }
}
