package org.robotui.player.layout;

import java.util.List;

/** A value in a record that can be browsed. */
public sealed interface FieldValue {

  /**
   * A whole number.
   *
   * @param value the number
   */
  record Whole(long value) implements FieldValue {}

  /**
   * A real number.
   *
   * @param value the number, possibly not finite
   */
  record Real(double value) implements FieldValue {}

  /**
   * Yes or no.
   *
   * @param value true for yes
   */
  record Flag(boolean value) implements FieldValue {}

  /**
   * A text.
   *
   * @param value without the zero at its end
   */
  record Text(String value) implements FieldValue {}

  /**
   * Packed bytes, such as a picture.
   *
   * @param value not to be changed
   */
  record Bytes(byte[] value) implements FieldValue {}

  /**
   * An array of numbers of any type.
   *
   * @param values not to be changed
   */
  record Numbers(double[] values) implements FieldValue {}

  /**
   * A structure.
   *
   * @param value its record
   */
  record Nested(PlayerRecord value) implements FieldValue {}

  /**
   * An array of structures.
   *
   * @param values their records
   */
  record Many(List<PlayerRecord> values) implements FieldValue {}
}
