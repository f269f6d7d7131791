package org.robotui.ros2.action;

import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.ThreadFactory;

/**
 * What a client of an action is given by its owner.
 *
 * @param threads makes the thread that notices the loss of the server; it lives while goals do
 * @param silence how long a server may be gone, or not mention a goal, before that is lost
 * @param maxGoals how many goals may be on their way at once
 */
public record Ros2ActionOptions(ThreadFactory threads, Duration silence, int maxGoals) {

  /** Checks the bounds. */
  public Ros2ActionOptions {
    Objects.requireNonNull(threads, "threads");
    if (silence.isNegative() || silence.isZero() || maxGoals < 1) {
      throw new IllegalArgumentException("a silence of " + silence + " and " + maxGoals + " goals");
    }
  }

  /**
   * Five seconds of silence, a hundred goals.
   *
   * @param threads makes the client's thread
   * @return the default
   */
  public static Ros2ActionOptions standard(ThreadFactory threads) {
    return new Ros2ActionOptions(threads, Duration.ofSeconds(5), 100);
  }
}
