package org.robotui.rfic.ros.internal;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import org.robotui.api.RficContext;
import org.robotui.rfic.ros.internal.graph.SharedCleanup;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Removes, beside all else, what earlier runs that were killed left at their masters: again and again, ever less often,
 * until all of these have answered, since a robot may be reached later than the workbench starts.
 */
final class RepeatedCleanup implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(RepeatedCleanup.class);
  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final Duration END = Duration.ofMillis(900);
  private static final Duration FIRST_PAUSE = Duration.ofSeconds(4);
  private static final Duration LONGEST_PAUSE = Duration.ofMinutes(1);

  private final Thread thread;

  RepeatedCleanup(RficContext context, SharedCleanup sweep) {
    this(context, sweep, FIRST_PAUSE);
  }

  RepeatedCleanup(RficContext context, SharedCleanup sweep, Duration firstPause) {
    Path folder = context.stateFolder();
    thread = context.threads().newThread(() -> tidy(folder, sweep, firstPause));
  }

  void start() {
    thread.start();
  }

  private static void tidy(Path folder, SharedCleanup sweep, Duration firstPause) {
    try {
      Duration pause = firstPause;
      while (!sweep.complete(folder, PATIENCE)) {
        Thread.sleep(pause);
        pause = pause.compareTo(LONGEST_PAUSE) < 0 ? pause.multipliedBy(2) : LONGEST_PAUSE;
      }
    } catch (InterruptedException e) {
      LOG.debug("ends before all masters have answered");
    } catch (IOException e) {
      LOG.warn("what earlier runs left at their masters is not known: {}", e.toString());
    }
  }

  /** Asks it to end; it does after the call under way. */
  void stop() {
    thread.interrupt();
  }

  @Override
  public void close() {
    stop();
    try {
      if (thread.isAlive()) { // a thread that never began cannot be joined
        thread.join(END);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
