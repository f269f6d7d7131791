package org.robotui.rtps;

/**
 * Hears which remote ends a reader or writer is connected to. Called one after the other, without a lock, on the thread
 * with which the participant receives or on that of its timers; it must not block.
 */
public interface MatchListener {

  /**
   * From now on samples go from one to the other.
   *
   * @param remote the other end
   */
  default void matched(EndpointInfo remote) {}

  /**
   * They do so no more.
   *
   * @param remote the other end
   * @param reason why, for a user to read
   */
  default void unmatched(EndpointInfo remote, String reason) {}

  /**
   * There is another end of this topic, but the two do not fit.
   *
   * @param mismatch which one, and why not
   */
  default void mismatched(Mismatch mismatch) {}
}
