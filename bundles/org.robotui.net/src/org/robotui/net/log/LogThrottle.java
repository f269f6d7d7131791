package org.robotui.net.log;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Decides which of many like events are logged: the first, second, fourth, eighth and so on, so that no peer can fill a
 * disk.
 */
public final class LogThrottle {

  private final AtomicLong count = new AtomicLong();

  /**
   * Counts an event.
   *
   * @return whether to log it
   */
  public boolean admit() {
    return Long.bitCount(count.incrementAndGet()) == 1;
  }

  /**
   * How many events there were, for the line that is logged.
   *
   * @return logged or not
   */
  public long count() {
    return count.get();
  }
}
