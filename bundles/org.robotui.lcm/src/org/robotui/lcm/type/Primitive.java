package org.robotui.lcm.type;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/** The built-in types of the LCM type language. All numbers travel big-endian. */
public enum Primitive {
  /** Signed 8-bit integer. */
  INT8("int8_t", 1),
  /** Signed 16-bit integer. */
  INT16("int16_t", 2),
  /** Signed 32-bit integer. */
  INT32("int32_t", 4),
  /** Signed 64-bit integer. */
  INT64("int64_t", 8),
  /** Unsigned 8-bit value. */
  BYTE("byte", 1),
  /** IEEE single. */
  FLOAT("float", 4),
  /** IEEE double. */
  DOUBLE("double", 8),
  /** One byte, 0 or 1. */
  BOOLEAN("boolean", 1),
  /** UTF-8 text: a 32-bit length that counts a final zero, the bytes, the zero. */
  STRING("string", 0);

  private static final Map<String, Primitive> BY_NAME =
      Arrays.stream(values()).collect(Collectors.toUnmodifiableMap(Primitive::lcmName, Function.identity()));

  private final String lcmName;
  private final int size;

  Primitive(String lcmName, int size) {
    this.lcmName = lcmName;
    this.size = size;
  }

  /**
   * Finds a built-in type.
   *
   * @param lcmName as written in {@code .lcm} files
   * @return empty if there is no such built-in type
   */
  public static Optional<Primitive> of(String lcmName) {
    return Optional.ofNullable(BY_NAME.get(lcmName));
  }

  /**
   * The name in {@code .lcm} files.
   *
   * @return such as {@code int32_t}
   */
  public String lcmName() {
    return lcmName;
  }

  /**
   * The number of bytes of one value.
   *
   * @return bytes; 0 for {@link #STRING}, whose size varies
   */
  public int size() {
    return size;
  }

  /**
   * Whether a member of this type may be the size of an array.
   *
   * @return true for the signed integers
   */
  public boolean isInteger() {
    return this == INT8 || this == INT16 || this == INT32 || this == INT64;
  }

  /**
   * Whether values are floating point numbers.
   *
   * @return true for {@link #FLOAT} and {@link #DOUBLE}
   */
  public boolean isFloating() {
    return this == FLOAT || this == DOUBLE;
  }

  /**
   * Whether an integer can be held.
   *
   * @param value the integer
   * @return true if it is in the range of this integer type, {@link #BYTE} included
   */
  boolean holds(long value) {
    return switch (this) {
      case INT8 -> value == (byte) value;
      case INT16 -> value == (short) value;
      case INT32 -> value == (int) value;
      case INT64 -> true;
      case BYTE -> value >= 0 && value <= 255;
      default -> false;
    };
  }
}
