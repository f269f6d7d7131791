package org.robotui.rtps.internal.participant;

import java.util.ArrayDeque;
import java.util.Deque;
import org.robotui.net.log.LogThrottle;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What listeners are to be told, one after the other, without a lock: it is queued under the lock of whoever knows, and
 * told by whoever comes first after that lock was released.
 */
final class MatchNotices {

  private static final Logger LOG = LoggerFactory.getLogger(MatchNotices.class);

  private final Deque<Runnable> queue = new ArrayDeque<>();
  private final LogThrottle faults = new LogThrottle();
  private boolean telling;

  synchronized void add(Runnable notice) {
    queue.add(notice);
  }

  /** Tells what is queued; returns at once where another thread, or a call above this one, is doing it. */
  void tell() {
    for (Runnable next = first(); next != null; next = next()) {
      try {
        next.run();
      } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
        if (faults.admit()) {
          LOG.error("a listener threw ({} times so far)", faults.count(), e);
        }
      }
    }
  }

  private synchronized Runnable first() {
    return telling ? null : next();
  }

  private synchronized Runnable next() {
    Runnable next = queue.poll();
    telling = next != null;
    return next;
  }
}
