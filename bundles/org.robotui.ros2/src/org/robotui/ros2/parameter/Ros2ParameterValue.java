package org.robotui.ros2.parameter;

import java.nio.ByteBuffer;
import java.util.List;

/** The value of a parameter. Arrays are not copied, and not to be written. */
public sealed interface Ros2ParameterValue {

  /** No value: the parameter is not set. */
  record Unset() implements Ros2ParameterValue {}

  /**
   * A truth value.
   *
   * @param value true or false
   */
  record OfBool(boolean value) implements Ros2ParameterValue {}

  /**
   * A whole number.
   *
   * @param value the number
   */
  record OfInteger(long value) implements Ros2ParameterValue {}

  /**
   * A real number.
   *
   * @param value the number
   */
  record OfDouble(double value) implements Ros2ParameterValue {}

  /**
   * A text.
   *
   * @param value the text
   */
  record OfText(String value) implements Ros2ParameterValue {}

  /**
   * Bytes.
   *
   * @param value the bytes, from position to limit
   */
  record OfBytes(ByteBuffer value) implements Ros2ParameterValue {}

  /**
   * Truth values.
   *
   * @param values true or false each
   */
  record OfBools(List<Boolean> values) implements Ros2ParameterValue {

    /** Copies the list. */
    public OfBools {
      values = List.copyOf(values);
    }
  }

  /**
   * Whole numbers.
   *
   * @param values the numbers
   */
  record OfIntegers(List<Long> values) implements Ros2ParameterValue {

    /** Copies the list. */
    public OfIntegers {
      values = List.copyOf(values);
    }
  }

  /**
   * Real numbers.
   *
   * @param values the numbers
   */
  record OfDoubles(List<Double> values) implements Ros2ParameterValue {

    /** Copies the list. */
    public OfDoubles {
      values = List.copyOf(values);
    }
  }

  /**
   * Texts.
   *
   * @param values the texts
   */
  record OfTexts(List<String> values) implements Ros2ParameterValue {

    /** Copies the list. */
    public OfTexts {
      values = List.copyOf(values);
    }
  }

  /**
   * The number of the type by {@code rcl_interfaces/msg/ParameterType}.
   *
   * @return 0 to 9
   */
  default int type() {
    return switch (this) {
      case Unset unset -> 0;
      case OfBool flag -> 1;
      case OfInteger whole -> 2;
      case OfDouble real -> 3;
      case OfText text -> 4;
      case OfBytes bytes -> 5;
      case OfBools flags -> 6;
      case OfIntegers wholes -> 7;
      case OfDoubles reals -> 8;
      case OfTexts texts -> 9;
    };
  }
}
