package org.robotui.carmen.message;

import java.util.List;
import org.robotui.carmen.format.IpcFormat;

/** A value of a field. Arrays that are given out must not be changed. */
public sealed interface IpcValue {

  /**
   * A whole number: int, boolean, char, byte.
   *
   * @param value characters and bytes from 0 to 255
   */
  record Whole(int value) implements IpcValue {}

  /**
   * A number of 32 bits with a fraction.
   *
   * @param value any, also none
   */
  record Small(float value) implements IpcValue {}

  /**
   * A number of 64 bits with a fraction.
   *
   * @param value any, also none
   */
  record Real(double value) implements IpcValue {}

  /**
   * A text; one that is absent and an empty one are the same on the wire.
   *
   * @param value its characters, of 8 bits each
   */
  record Text(String value) implements IpcValue {}

  /**
   * An array of characters or bytes.
   *
   * @param values its elements
   */
  record Octets(byte[] values) implements IpcValue {}

  /**
   * An array of whole numbers.
   *
   * @param values its elements
   */
  record Wholes(int[] values) implements IpcValue {}

  /**
   * An array of numbers of 32 bits.
   *
   * @param values its elements
   */
  record Smalls(float[] values) implements IpcValue {}

  /**
   * An array of numbers of 64 bits.
   *
   * @param values its elements
   */
  record Reals(double[] values) implements IpcValue {}

  /**
   * An array of anything else.
   *
   * @param values its elements
   */
  record Items(List<IpcValue> values) implements IpcValue {
    /** Copies the list. */
    public Items {
      values = List.copyOf(values);
    }
  }

  /**
   * A structure.
   *
   * @param record its fields
   */
  record Members(IpcRecord record) implements IpcValue {}

  /**
   * A format, as centrals send it.
   *
   * @param format what it says
   */
  record Form(IpcFormat format) implements IpcValue {}

  /** A pointer to nothing. */
  record Absent() implements IpcValue {}

  /**
   * It as a number.
   *
   * @return not a number where it is none
   */
  default double number() {
    return switch (this) {
      case Whole w -> w.value();
      case Small s -> s.value();
      case Real r -> r.value();
      default -> Double.NaN;
    };
  }
}
