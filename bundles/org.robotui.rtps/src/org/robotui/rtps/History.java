package org.robotui.rtps;

/** What an endpoint keeps. */
public enum History {
  /** The newest samples, as many as its depth says. */
  KEEP_LAST,
  /** All samples, until everybody has them or its memory is full. */
  KEEP_ALL
}
