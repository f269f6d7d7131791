package org.robotui.uic.plot.internal.signal;

/**
 * The slope between two samples, put in their middle, where it is most nearly true. Nothing is computed across a break.
 */
final class DerivativeNode implements Sink {
  private static final double NANO = 1e-9;

  private final Sink out;
  private long lastTime;
  private double last = Double.NaN;

  DerivativeNode(Sink out) {
    this.out = out;
  }

  @Override
  public void accept(long time, double value) {
    if (Double.isNaN(value)) {
      out.accept(Double.isNaN(last) ? time : lastTime, Double.NaN);
      last = Double.NaN;
    } else if (Double.isNaN(last)) {
      keep(time, value);
    } else if (time > lastTime) {
      out.accept(lastTime + (time - lastTime) / 2, (value - last) / ((time - lastTime) * NANO));
      keep(time, value);
    }
  }

  private void keep(long time, double value) {
    lastTime = time;
    last = value;
  }
}
