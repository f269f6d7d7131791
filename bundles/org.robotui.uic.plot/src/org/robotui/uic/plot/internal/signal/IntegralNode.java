package org.robotui.uic.plot.internal.signal;

/** Adds up trapezoids from the first sample on. Over a break nothing is added, since nothing is known of it. */
final class IntegralNode implements Sink {
  private static final double NANO = 1e-9;

  private final Sink out;
  private long lastTime;
  private double last = Double.NaN;
  private double area;

  IntegralNode(Sink out) {
    this.out = out;
  }

  @Override
  public void accept(long time, double value) {
    if (Double.isNaN(value)) {
      last = Double.NaN;
      out.accept(time, Double.NaN);
      return;
    }
    if (!Double.isNaN(last)) {
      area += (value + last) / 2 * ((time - lastTime) * NANO);
    }
    lastTime = time;
    last = value;
    out.accept(time, area);
  }
}
