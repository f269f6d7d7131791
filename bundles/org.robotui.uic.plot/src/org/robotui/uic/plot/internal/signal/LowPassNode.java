package org.robotui.uic.plot.internal.signal;

/** A low-pass of the first order, whatever the distances of samples are. A break begins it anew. */
final class LowPassNode implements Sink {
  private static final double NANO = 1e-9;

  private final Sink out;
  private final double perSecond;
  private long lastTime;
  private double last = Double.NaN;

  LowPassNode(double hertz, Sink out) {
    this.perSecond = 2 * Math.PI * hertz;
    this.out = out;
  }

  @Override
  public void accept(long time, double value) {
    double share = -Math.expm1(-perSecond * (time - lastTime) * NANO);
    last = Double.isFinite(last) && Double.isFinite(value) ? last + (value - last) * share : value;
    lastTime = time;
    out.accept(time, last);
  }
}
