package org.robotui.web;

import java.util.concurrent.CompletableFuture;

/** How a link fares. Safe for all threads. */
public interface LinkMonitor {

  /**
   * When the link has ended.
   *
   * @return completes with the reason, for users
   */
  CompletableFuture<String> whenEnded();

  /** Asks the peer for a sign of life where it is time. To be called often. */
  void beat();

  /**
   * How long nothing at all has come although a sign of life was asked for.
   *
   * @return nanoseconds, 0 where none is awaited
   */
  long silentNanos();

  /**
   * What is wrong with the link.
   *
   * @return a sentence for users; empty where all is well
   */
  String trouble();
}
