package org.robotui.foxglove;

import java.util.List;
import java.util.Map;
import java.util.Set;

/** Hears what a server says beside messages, one call at a time, on the threads of the link. Calls must not block. */
public interface FoxgloveListener {

  /**
   * Something came that nobody can read, and it was ignored.
   *
   * @param reason for users
   */
  void onUnreadable(String reason);

  /**
   * The server says its time.
   *
   * @param nanos by its clock
   */
  default void onTime(long nanos) {}

  /**
   * The server tells users something.
   *
   * @param level 0 for information, 1 for a warning, 2 for an error
   * @param message what it tells
   */
  default void onStatus(int level, String message) {}

  /** The server has other channels or services than before. */
  default void onOffers() {}

  /**
   * Parameters have changed that are followed.
   *
   * @param values those that have changed
   */
  default void onParameters(List<Parameter> values) {}

  /**
   * The whole graph as far as it is known.
   *
   * @param publishers who publishes, by topic
   * @param subscribers who subscribes, by topic
   */
  default void onGraph(Map<String, Set<String>> publishers, Map<String, Set<String>> subscribers) {}
}
