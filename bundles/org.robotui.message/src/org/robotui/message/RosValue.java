package org.robotui.message;

import java.util.List;

/** What a field of a {@link DynamicMessage} holds. */
public sealed interface RosValue {

  /**
   * A bool.
   *
   * @param value true or false
   */
  record Flag(boolean value) implements RosValue {}

  /**
   * An integer.
   *
   * @param value the number; for {@code uint64} its bits
   * @param type the built-in type
   */
  record Whole(long value, Primitive type) implements RosValue {

    /**
     * The number as text.
     *
     * @return decimal digits, also for a {@code uint64} beyond the range of {@code long}
     */
    public String text() {
      return type == Primitive.UINT64 ? Long.toUnsignedString(value) : Long.toString(value);
    }
  }

  /**
   * A floating point number.
   *
   * @param value the number
   * @param type the built-in type
   */
  record Real(double value, Primitive type) implements RosValue {}

  /**
   * A text.
   *
   * @param value the text
   */
  record Text(String value) implements RosValue {}

  /**
   * A time or duration.
   *
   * @param nanos nanoseconds
   * @param type {@link Primitive#TIME} or {@link Primitive#DURATION}
   */
  record Instant(long nanos, Primitive type) implements RosValue {}

  /**
   * An array of a built-in type other than text.
   *
   * @param values the numbers
   */
  record Numbers(PrimitiveArray values) implements RosValue {}

  /**
   * An array of texts.
   *
   * @param values the texts, decoded when asked for
   */
  record Texts(List<String> values) implements RosValue {}

  /**
   * A message within the message.
   *
   * @param value the inner message
   */
  record Nested(DynamicMessage value) implements RosValue {}

  /**
   * An array of messages.
   *
   * @param values the messages, made when asked for
   */
  record Messages(List<DynamicMessage> values) implements RosValue {}
}
