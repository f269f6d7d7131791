package org.robotui.rtps;

import java.util.List;

/** What readers and writers of this participant have in common. Safe for all threads. */
public interface Endpoint extends AutoCloseable {

  /**
   * What is announced of it. Of an adapting reader this changes, its guid as well.
   *
   * @return as others see it now
   */
  EndpointInfo info();

  /**
   * With whom it exchanges samples.
   *
   * @return the other ends, as of now
   */
  List<EndpointInfo> matched();

  /**
   * The other ends of its topic with which it exchanges none.
   *
   * @return them, each with the reasons
   */
  List<Mismatch> mismatches();

  /**
   * Adds a listener; it is told first, on this thread, what is matched and mismatched already.
   *
   * @param listener hears of matches until the endpoint is closed
   */
  void addListener(MatchListener listener);

  /** Takes it back from the network. Its listeners may hear of what is just being received, then of nothing more. */
  @Override
  void close();
}
