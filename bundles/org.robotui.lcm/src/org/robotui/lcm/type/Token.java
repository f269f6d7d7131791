package org.robotui.lcm.type;

/** A piece of a {@code .lcm} file; the one after the last is empty. */
record Token(String text, Place place) {

  boolean isEnd() {
    return text.isEmpty();
  }

  boolean is(String expected) {
    return text.equals(expected);
  }

  /** For a user to read. */
  String quoted() {
    return isEnd() ? "the end of the file" : "'" + (text.length() > 40 ? text.substring(0, 40) + "..." : text) + "'";
  }
}
