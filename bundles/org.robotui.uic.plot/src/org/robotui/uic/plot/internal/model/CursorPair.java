package org.robotui.uic.plot.internal.model;

import org.robotui.ui.Figures;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/** Two times that are compared. */
public record CursorPair(long a, long b) {
  /** In the middle of what is seen. */
  public static CursorPair within(TimeSpan span) {
    return new CursorPair(span.from() + span.length() / 3, span.from() + span.length() / 3 * 2);
  }

  public CursorPair withA(long time) {
    return new CursorPair(time, b);
  }

  public CursorPair withB(long time) {
    return new CursorPair(a, time);
  }

  public double seconds() {
    return (b - a) / (double) TimeSpan.SECOND;
  }

  /** For example {@code Δt 0.420 s · 2.38 Hz}. */
  public String text() {
    double seconds = seconds();
    String length = Math.abs(seconds) < 0.1 ? Figures.of(seconds * 1e3, 3, "ms") : Figures.of(seconds, 3, "s");
    return "\u0394t " + length + (a == b ? "" : " \u00b7 1/\u0394t " + Readout.of(1 / Math.abs(seconds), "Hz"));
  }
}
