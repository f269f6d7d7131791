package org.robotui.headless.internal;

/** What a run of the application shows, again and again. */
interface Output {
  /** How long to wait between two calls of {@link #show}. */
  long periodMillis();

  void show();

  /** Leaves the terminal as it was. */
  default void end() {}
}
