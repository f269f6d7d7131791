package org.robotui.data;

/** What a consumer that connects late is given at once. */
public enum Late {
  /** Nothing: it waits for the next value. */
  NONE,
  /** The last value, if there was one. */
  LAST,
  /** The newest value of every key. */
  ALL_KEYS
}
