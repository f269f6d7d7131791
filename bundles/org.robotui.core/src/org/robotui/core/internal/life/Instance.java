package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.Optional;
import org.robotui.api.ComponentType;

/** A running component. */
interface Instance {
  /** Creates and starts it. Blocks within limits. */
  void start() throws Guarded.GuardException, InterruptedException;

  /** Ends it within a limit. Returns what could not be ended of what it is known to have. */
  Optional<String> close(Duration limit);

  /** Its id in its RUIC. */
  String instance();

  /** What it is an instance of. */
  ComponentType type();

  /** Names bundle and class, for messages. */
  String origin();

  /** A message of what it left. */
  default String left(String what) {
    return instance() + " " + what + " (" + origin() + ")";
  }
}
