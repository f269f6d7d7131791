package org.robotui.lcm.type;

/** One dimension of an array. */
public sealed interface Dimension {

  /**
   * How it was written, which is a part of the fingerprint: a number, or the name of the member. A constant stands here
   * with its value as that was written.
   *
   * @return the text
   */
  String text();

  /**
   * A size that never changes.
   *
   * @param size the number of elements, at least 1
   * @param text the number as it was written
   */
  record Fixed(int size, String text) implements Dimension {}

  /**
   * A size that another member of the same message holds.
   *
   * @param text the name of the member, which comes before the array
   */
  record Variable(String text) implements Dimension {}
}
