package org.robotui.lcm.type;

import java.util.List;

/** What a member of a record holds. */
public sealed interface LcmValue {

  /**
   * An integer or a {@code byte}.
   *
   * @param value the number; 0 to 255 for a {@code byte}
   */
  record Whole(long value) implements LcmValue {}

  /**
   * A floating point number.
   *
   * @param value the number
   */
  record Real(double value) implements LcmValue {}

  /**
   * A truth value.
   *
   * @param value true or false
   */
  record Flag(boolean value) implements LcmValue {}

  /**
   * A text.
   *
   * @param value without the final zero
   */
  record Text(String value) implements LcmValue {}

  /**
   * A struct.
   *
   * @param value its members
   */
  record Nested(LcmRecord value) implements LcmValue {}

  /**
   * An array of numbers or truth values.
   *
   * @param value where they stand
   */
  record Numbers(NumberArray value) implements LcmValue {}

  /**
   * An array of texts.
   *
   * @param values row by row
   * @param shape the size of each dimension, outermost first
   */
  record Texts(List<String> values, List<Integer> shape) implements LcmValue {

    /** Copies the lists. */
    public Texts {
      values = List.copyOf(values);
      shape = List.copyOf(shape);
    }
  }

  /**
   * An array of structs.
   *
   * @param values row by row; where all have the same number of bytes, each is decoded when it is asked for
   * @param shape the size of each dimension, outermost first
   */
  record Records(List<LcmRecord> values, List<Integer> shape) implements LcmValue {

    /** Copies the shape. */
    public Records {
      shape = List.copyOf(shape);
    }
  }
}
