package org.robotui.rtps;

/**
 * Receives the samples of a topic. It acknowledges what came from the network when it came, not when its listener has
 * had it: no reliable writer waits for a listener.
 */
public interface Reader extends Endpoint {

  /**
   * What was counted.
   *
   * @return the figures so far
   */
  ReaderStatistics statistics();
}
