package org.robotui.lcm.internal.io;

import java.util.concurrent.atomic.AtomicLong;

/** Tells which of many like events to log: the first, and ever fewer of those that follow, so that no peer can fill a disk. */
public final class Seldom {

  private final AtomicLong count = new AtomicLong();

  /** Counts an event; answers whether to tell of it. */
  public boolean again() {
    return Long.bitCount(count.incrementAndGet()) == 1;
  }

  /** How many there were. */
  public long count() {
    return count.get();
  }
}
