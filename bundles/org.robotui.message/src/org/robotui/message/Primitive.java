package org.robotui.message;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The built-in types of ROS message definitions. */
public enum Primitive {
  /** One byte, 0 or 1. */
  BOOL("bool", 1),
  /** Signed 8-bit integer. */
  INT8("int8", 1),
  /** Unsigned 8-bit integer. */
  UINT8("uint8", 1),
  /** The old name of {@link #INT8}. */
  BYTE("byte", 1),
  /** The old name of {@link #UINT8}. */
  CHAR("char", 1),
  /** Signed 16-bit integer. */
  INT16("int16", 2),
  /** Unsigned 16-bit integer. */
  UINT16("uint16", 2),
  /** Signed 32-bit integer. */
  INT32("int32", 4),
  /** Unsigned 32-bit integer. */
  UINT32("uint32", 4),
  /** Signed 64-bit integer. */
  INT64("int64", 8),
  /** Unsigned 64-bit integer. */
  UINT64("uint64", 8),
  /** IEEE single. */
  FLOAT32("float32", 4),
  /** IEEE double. */
  FLOAT64("float64", 8),
  /** Text with a 32-bit length. */
  STRING("string", 0),
  /** Text of wide characters, of ROS 2 alone. */
  WSTRING("wstring", 0),
  /** Unsigned seconds and nanoseconds, 32 bits each. */
  TIME("time", 8),
  /** Signed seconds and nanoseconds, 32 bits each. */
  DURATION("duration", 8);

  private static final Map<String, Primitive> BY_NAME = byName();

  private final String rosName;
  private final int size;

  Primitive(String rosName, int size) {
    this.rosName = rosName;
    this.size = size;
  }

  private static Map<String, Primitive> byName() {
    Map<String, Primitive> all = new HashMap<>();
    for (Primitive each : values()) {
      all.put(each.rosName, each);
    }
    return all;
  }

  /**
   * Finds a built-in type.
   *
   * @param rosName as written in definitions
   * @return empty if there is no such built-in type
   */
  public static Optional<Primitive> of(String rosName) {
    return Optional.ofNullable(BY_NAME.get(rosName));
  }

  /**
   * The name in definitions.
   *
   * @return such as {@code float32}
   */
  public String rosName() {
    return rosName;
  }

  /**
   * The number of bytes of one value.
   *
   * @return bytes; 0 for texts, whose size varies
   */
  public int size() {
    return size;
  }

  /**
   * Whether values are floating point numbers.
   *
   * @return true for {@link #FLOAT32} and {@link #FLOAT64}
   */
  public boolean isFloating() {
    return this == FLOAT32 || this == FLOAT64;
  }

  /**
   * Whether values are texts.
   *
   * @return true for {@link #STRING} and {@link #WSTRING}
   */
  public boolean isText() {
    return this == STRING || this == WSTRING;
  }

  /**
   * Whether values are times or durations, which this library holds as nanoseconds.
   *
   * @return true for {@link #TIME} and {@link #DURATION}
   */
  public boolean isTemporal() {
    return this == TIME || this == DURATION;
  }
}
