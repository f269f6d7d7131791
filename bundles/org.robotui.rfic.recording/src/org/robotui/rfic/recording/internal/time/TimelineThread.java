package org.robotui.rfic.recording.internal.time;

import java.time.Duration;
import org.robotui.api.RficWorker;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The thread of the timeline, which there is while a recording is open. */
final class TimelineThread {
  private static final Logger LOG = LoggerFactory.getLogger(TimelineThread.class);
  private static final Duration PATIENCE = Duration.ofMillis(500);

  private final Thread thread;
  private volatile boolean ended;

  private TimelineThread(Runnable turn) {
    thread = Thread.ofPlatform().daemon().name("timeline of recordings").unstarted(() -> run(turn));
  }

  /** Takes turns from now on; each waits until there is something to do. */
  static TimelineThread start(Runnable turn) {
    TimelineThread started = new TimelineThread(turn);
    started.thread.start();
    return started;
  }

  private void run(Runnable turn) {
    while (!ended) {
      try {
        turn.run();
      } catch (RuntimeException e) {
        LOG.error("The timeline of recordings goes on after an error", e);
      }
    }
  }

  /** Ends after the turn that is being taken, and waits a moment for that. */
  void end(Runnable wake) {
    ended = true;
    wake.run();
    RficWorker.join(thread, System.nanoTime() + PATIENCE.toNanos());
  }
}
