package org.robotui.data.record;

/** What a field of a record may hold, as {@link FieldValue} is what it does hold. */
public sealed interface FieldShape {
  /** A truth value. */
  record Flag() implements FieldShape {}

  /**
   * A whole number.
   *
   * @param bits 8, 16, 32 or 64
   * @param signed whether it may be negative
   */
  record Whole(int bits, boolean signed) implements FieldShape {}

  /**
   * A number.
   *
   * @param bits 32 or 64
   */
  record Real(int bits) implements FieldShape {}

  /** A text. */
  record Text() implements FieldShape {}

  /** A point in time; given as a Long, nanoseconds since the epoch of the robot. */
  record Time() implements FieldShape {}

  /** A length of time; given as a Long, nanoseconds, which may be negative. */
  record Duration() implements FieldShape {}

  /**
   * A record within the record.
   *
   * @param shape its form
   */
  record Nested(RecordShape shape) implements FieldShape {}

  /**
   * Many values of one form.
   *
   * @param element the form of each
   * @param size how many there are; 0 for any number
   */
  record Many(FieldShape element, int size) implements FieldShape {}
}
