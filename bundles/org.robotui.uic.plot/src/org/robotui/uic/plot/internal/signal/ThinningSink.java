package org.robotui.uic.plot.internal.signal;

/**
 * Keeps of so many samples in a row the smallest and the largest, in the order of time, so that a line looks the same
 * from afar. Breaks stay. One thread.
 */
public final class ThinningSink implements Sink {
  private static final int LEAST = 3;

  private final int every;
  private final Sink out;
  private int count;
  private long lowTime;
  private double low;
  private long highTime;
  private double high;

  /** Of fewer than three samples in a row all are kept. */
  public ThinningSink(int every, Sink out) {
    this.every = every;
    this.out = out;
  }

  @Override
  public void accept(long time, double value) {
    if (every < LEAST) {
      out.accept(time, value);
    } else if (Double.isFinite(value)) {
      note(time, value);
    } else {
      flush();
      out.accept(time, value);
    }
  }

  private void note(long time, double value) {
    if (count == 0 || value < low) {
      low = value;
      lowTime = time;
    }
    if (count == 0 || value > high) {
      high = value;
      highTime = time;
    }
    count++;
    if (count == every) {
      flush();
    }
  }

  /** Gives what waits: the end. */
  public void flush() {
    if (count == 0) {
      return;
    }
    count = 0;
    if (lowTime == highTime) {
      out.accept(lowTime, low);
    } else if (lowTime < highTime) {
      out.accept(lowTime, low);
      out.accept(highTime, high);
    } else {
      out.accept(highTime, high);
      out.accept(lowTime, low);
    }
  }
}
