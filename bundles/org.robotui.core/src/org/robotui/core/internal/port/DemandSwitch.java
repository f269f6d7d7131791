package org.robotui.core.internal.port;

import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.api.port.Demand;

/**
 * Counts consumers and tells a producer when the first comes and the last goes, on a serial executor that outlives what
 * is thrown at it.
 */
final class DemandSwitch {
  private final Demand demand;
  private final Executor serial;
  private final AtomicInteger consumers = new AtomicInteger();
  private volatile boolean ended;
  private boolean told; // only on the serial executor

  DemandSwitch(Demand demand, Executor serial) {
    this.demand = demand;
    this.serial = serial;
  }

  void add(int change) {
    consumers.addAndGet(change);
    serial.execute(this::tell);
  }

  boolean wanted() {
    return consumers.get() > 0;
  }

  /** The producer has ended and is told nothing any more. */
  void end() {
    ended = true;
  }

  private void tell() {
    boolean wanted = wanted();
    if (wanted != told && !ended) {
      told = wanted;
      demand.changed(wanted);
    }
  }
}
