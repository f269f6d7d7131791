package org.robotui.ui.ask;

import java.util.OptionalDouble;

/**
 * What was measured of a topic over the last seconds. NaN where it cannot be told.
 *
 * @param hertz messages per second
 * @param jitter standard deviation of the periods, seconds
 * @param shortest period, seconds
 * @param longest period, seconds
 * @param bytesPerSecond of messages as they come, where their size is known
 * @param meanSize bytes of a message, where it is known
 * @param count messages since measuring began
 */
public record Measure(
    double hertz, double jitter, double shortest, double longest, OptionalDouble bytesPerSecond,
    OptionalDouble meanSize, long count) {
  /** Before the first message. */
  public static final Measure NOTHING = new Measure(
      Double.NaN, Double.NaN, Double.NaN, Double.NaN, OptionalDouble.empty(), OptionalDouble.empty(), 0);
}
