package org.robotui.rosbridge;

import org.robotui.web.Arrivals;

/** A topic that is received. Safe for all threads. */
public final class BridgeSubscription implements AutoCloseable {

  private final Arrivals.Source<?> source;
  private final Runnable end;

  BridgeSubscription(Arrivals.Source<?> source, Runnable end) {
    this.source = source;
    this.end = end;
  }

  /**
   * How many messages were dropped since this was asked, as newer ones came before they were taken.
   *
   * @return how many
   */
  public long dropped() {
    return source.dropped();
  }

  /** Ends it; called once. */
  @Override
  public void close() {
    source.close();
    end.run();
  }
}
