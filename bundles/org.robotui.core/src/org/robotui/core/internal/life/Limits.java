package org.robotui.core.internal.life;

import java.time.Duration;

/** How long foreign code may take before it is given up. */
final class Limits {
  /** What an instance does for the first time: where all start at once, classes have to be loaded from a cold disk. */
  static final Duration FIRST = Duration.ofSeconds(10);

  /** A tick of a view that has ticked before. */
  static final Duration TICK = Duration.ofSeconds(2);

  private Limits() {}
}
