package org.robotui.uic.body.internal.model;

import java.util.List;
import java.util.OptionalDouble;

/**
 * What one line said up to now.
 *
 * @param line as it is
 * @param moments the newest first, each time that it changed
 * @param curve numbers with their ages, the oldest first; of lines that are numbers
 */
public record BodyPast(BodyLine line, List<Moment> moments, List<Point> curve) {
  /**
   * When it began to say something.
   *
   * @param ago seconds
   * @param value what it said
   */
  public record Moment(double ago, String value) {}

  /**
   * A number.
   *
   * @param ago seconds
   * @param value the number
   */
  public record Point(double ago, double value) {}

  /** Copies the lists. */
  public BodyPast {
    moments = List.copyOf(moments);
    curve = List.copyOf(curve);
  }

  OptionalDouble extreme(boolean most) {
    return most ? curve.stream().mapToDouble(Point::value).max() : curve.stream().mapToDouble(Point::value).min();
  }

  /** The largest number; none where there are none. */
  public OptionalDouble most() {
    return extreme(true);
  }

  /** The smallest number; none where there are none. */
  public OptionalDouble least() {
    return extreme(false);
  }
}
