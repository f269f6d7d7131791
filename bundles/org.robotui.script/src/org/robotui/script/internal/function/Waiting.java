package org.robotui.script.internal.function;

import java.time.Duration;
import java.util.Optional;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;

/** Looks again and again, on the thread of the script. */
final class Waiting {
  static final Duration LONG = Duration.ofSeconds(30);
  static final Duration LOOK = Duration.ofMillis(20);

  private Waiting() {}

  /** What is waited for. */
  interface Condition {
    boolean holds() throws ScriptFailure, InterruptedException;
  }

  /** What is looked for. */
  interface Sought<T> {
    Optional<T> look() throws ScriptFailure, InterruptedException;
  }

  /** Waits until a condition holds; nothing where it does not in time. */
  static Optional<Boolean> until(ScriptCall call, Duration limit, Condition condition)
      throws ScriptFailure, InterruptedException {
    return forSome(call, limit, () -> condition.holds() ? Optional.of(true) : Optional.empty());
  }

  /** Waits for something; looks at least once. */
  static <T> Optional<T> forSome(ScriptCall call, Duration limit, Sought<T> sought)
      throws ScriptFailure, InterruptedException {
    long end = System.nanoTime() + limit.toNanos();
    Optional<T> found = sought.look();
    while (found.isEmpty() && System.nanoTime() < end) {
      call.pause(LOOK);
      found = sought.look();
    }
    return found;
  }
}
