package org.robotui.message;

/** Whose definitions and bytes messages are of. The generations have most types in common, by name and fields. */
public enum Generation {

  /** Times are built in; a type is compared by the sum of its definition. */
  ROS1(Encoding.ROS1),
  /**
   * Types may have three parts ({@code std_msgs/msg/Header}), texts and arrays a bound, fields a default. The types of
   * {@code builtin_interfaces} count as the built-in times, and a message without fields has one byte.
   */
  ROS2(Encoding.CDR);

  private final Encoding encoding;

  Generation(Encoding encoding) {
    this.encoding = encoding;
  }

  /**
   * How messages of this generation are sent.
   *
   * @return the encoding
   */
  public Encoding encoding() {
    return encoding;
  }

  /**
   * The name of a type as this library has it, whichever form it was given in.
   *
   * @param type such as {@code std_msgs/msg/Header} or {@code std_msgs/Header}
   * @return such as {@code std_msgs/Header}
   */
  public static String plainName(String type) {
    int first = type.indexOf('/');
    int last = type.lastIndexOf('/');
    return first == last ? type : type.substring(0, first) + type.substring(last);
  }
}
