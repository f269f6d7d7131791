package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.Optional;

/** A running component. */
interface Instance {
  /** Creates and starts it. Blocks within limits. */
  void start() throws Guarded.GuardException, InterruptedException;

  /** Ends it within a limit. Returns what could not be ended. */
  Optional<String> close(Duration limit);

  /** Names bundle and class, for messages. */
  String origin();
}
