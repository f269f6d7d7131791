package org.robotui.uic.plot.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.model.ValueSpan;
import org.robotui.uic.plot.internal.trace.Curve;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * Where an axis lies on the screen and what it shows there.
 *
 * @param index which axis
 * @param traces its traces
 * @param plot where lines are drawn
 * @param legend where names and figures stand; empty where they stand nowhere
 * @param times below the plot, where it has a time scale of its own; empty otherwise
 * @param span the time from the left to the right edge
 * @param left the values at the left scale
 * @param right the values at the right scale, where there is one
 * @param across the values from the left to the right edge, where these are no times
 */
record AxisFrame(
    int index, List<TraceView> traces, Rectangle plot, Rectangle legend, Rectangle times, TimeSpan span, ValueSpan left,
    Optional<ValueSpan> right, Optional<ValueSpan> across) {
  private static final double FAR = 20_000;

  /** Whether its traces are shown over another signal. */
  boolean isCurve() {
    return across.isPresent();
  }

  /** Where a value of the signal across lies. */
  float across(double value) {
    ValueSpan values = across.orElseThrow();
    return (float) Math.clamp(plot.x + (value - values.low()) / values.length() * plot.width, -FAR, FAR);
  }

  /** The value of the signal across at a place. */
  double valueAcross(int x) {
    ValueSpan values = across.orElseThrow();
    return values.low() + (double) (x - plot.x) / Math.max(1, plot.width) * values.length();
  }

  /** What a point of the screen shows of both scales. */
  Curve.Fineness fineness(boolean atRight) {
    return new Curve.Fineness(across.orElseThrow().length() / Math.max(1, plot.width),
        values(atRight).length() / Math.max(1, plot.height));
  }

  ValueSpan values(boolean atRight) {
    return atRight ? right.orElse(left) : left;
  }

  float x(long time) {
    double share = (double) (time - span.from()) / Math.max(1, span.length());
    return (float) Math.clamp(plot.x + share * plot.width, -FAR, FAR);
  }

  float y(double value, boolean atRight) {
    ValueSpan values = values(atRight);
    double share = (value - values.low()) / values.length();
    return (float) Math.clamp(plot.y + plot.height - share * plot.height, -FAR, FAR);
  }

  long time(int x) {
    return span.from() + Math.round((double) (x - plot.x) / Math.max(1, plot.width) * span.length());
  }

  double value(int y, boolean atRight) {
    ValueSpan values = values(atRight);
    return values.low() + (double) (plot.y + plot.height - y) / Math.max(1, plot.height) * values.length();
  }

  /** The time that some points are wide. */
  long time(double points) {
    return Math.round(points / Math.max(1, plot.width) * span.length());
  }
}
