package org.robotui.uic.plot.internal.signal;

/** Adds whole turns to an angle so that it goes on where it would jump. A break begins it anew. */
final class UnwrapNode implements Sink {
  private static final double TURN = 2 * Math.PI;

  private final Sink out;
  private double last = Double.NaN;

  UnwrapNode(Sink out) {
    this.out = out;
  }

  @Override
  public void accept(long time, double value) {
    last = Double.isFinite(last) && Double.isFinite(value) ? value + TURN * Math.rint((last - value) / TURN) : value;
    out.accept(time, last);
  }
}
