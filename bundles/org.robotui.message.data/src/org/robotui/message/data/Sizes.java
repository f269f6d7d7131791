package org.robotui.message.data;

/** Counts and lengths of messages, which ROS sends as unsigned numbers of 32 bits. */
final class Sizes {
  private Sizes() {}

  /** The number, where an array can be that long; else its name is said. */
  static int of(String name, long value) {
    if (value < 0 || value > Integer.MAX_VALUE) {
      throw new IllegalArgumentException(name + ": is " + value + ", must be from 0 to " + Integer.MAX_VALUE);
    }
    return (int) value;
  }
}
