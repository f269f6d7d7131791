package org.robotui.web;

/** Something that a peer was asked to send, and sends until this is closed. Safe for all threads. */
public final class ArrivalSubscription implements AutoCloseable {

  private final Arrivals.Source<?> source;
  private final Runnable end;

  /**
   * Has been asked for.
   *
   * @param source where its messages arrive
   * @param end asks the peer to stop
   */
  public ArrivalSubscription(Arrivals.Source<?> source, Runnable end) {
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
