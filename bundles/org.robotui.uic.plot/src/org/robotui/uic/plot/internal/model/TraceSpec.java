package org.robotui.uic.plot.internal.model;

import java.util.Optional;
import java.util.OptionalInt;

/**
 * A trace as it is configured.
 *
 * @param signal what it shows, as {@link org.robotui.uic.plot.internal.signal.ExprParser} reads it; may be wrong
 * @param label in place of one made of the signal
 * @param unit in place of the one known for the field
 * @param colour index of the theme's trace colours
 * @param style in place of that of the plot
 * @param right whether it belongs to the scale at the right
 * @param hidden whether it is not drawn
 */
public record TraceSpec(
    String signal,
    Optional<String> label,
    Optional<String> unit,
    OptionalInt colour,
    Optional<LineStyle> style,
    boolean right,
    boolean hidden) {
  public static TraceSpec of(String signal) {
    return new TraceSpec(signal, Optional.empty(), Optional.empty(), OptionalInt.empty(), Optional.empty(), false,
        false);
  }

  public TraceSpec withSignal(String next) {
    return new TraceSpec(next, Optional.empty(), Optional.empty(), colour, style, right, hidden);
  }

  /** The same by a name of its signal. */
  public TraceSpec named(String name) {
    return new TraceSpec(name, label, unit, colour, style, right, hidden);
  }

  public TraceSpec withLabel(Optional<String> next) {
    return new TraceSpec(signal, next, unit, colour, style, right, hidden);
  }

  public TraceSpec withColour(int next) {
    return new TraceSpec(signal, label, unit, OptionalInt.of(next), style, right, hidden);
  }

  public TraceSpec withStyle(Optional<LineStyle> next) {
    return new TraceSpec(signal, label, unit, colour, next, right, hidden);
  }

  public TraceSpec withRight(boolean next) {
    return new TraceSpec(signal, label, unit, colour, style, next, hidden);
  }

  public TraceSpec withHidden(boolean next) {
    return new TraceSpec(signal, label, unit, colour, style, right, next);
  }
}
