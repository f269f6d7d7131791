package org.robotui.data.record;

import java.util.List;
import org.robotui.data.array.Doubles;

/** What a field of a dynamic record holds. */
public sealed interface FieldValue {
  /**
   * A number.
   *
   * @param value the number; integers beyond 2^53 lose precision here, {@code exact} keeps them
   * @param exact its digits as the robot means them
   */
  record Num(double value, String exact) implements FieldValue {}

  /**
   * A truth value.
   *
   * @param value true or false
   */
  record Flag(boolean value) implements FieldValue {}

  /**
   * A text.
   *
   * @param value the text
   */
  record Text(String value) implements FieldValue {}

  /**
   * A point in time or a duration.
   *
   * @param nanos nanoseconds
   */
  record Time(long nanos) implements FieldValue {}

  /**
   * Many numbers.
   *
   * @param values the numbers
   */
  record Numbers(Doubles values) implements FieldValue {}

  /**
   * Many values.
   *
   * @param values the values
   */
  record Items(List<FieldValue> values) implements FieldValue {
    /**
     * Copies the list.
     *
     * @param values the values
     */
    public Items {
      values = List.copyOf(values);
    }
  }

  /**
   * A record within the record.
   *
   * @param value the inner record
   */
  record Nested(DynamicRecord value) implements FieldValue {}
}
