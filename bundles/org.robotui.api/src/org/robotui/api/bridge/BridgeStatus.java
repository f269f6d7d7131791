package org.robotui.api.bridge;

import java.util.Optional;

/**
 * How one way of a bridge is doing, at one moment.
 *
 * @param name of the bridge
 * @param from where values come from
 * @param to where they go
 * @param state how it is doing
 * @param text the same as a sentence for users
 * @param counts what has become of values since it began
 * @param rateHz values that passed in a second, over the last seconds
 * @param lagSeconds how long values take from being received until they are handed on, typically; NaN before the first
 * @param holder who has control of the robot where the bridge commands it; none where it does not, or nobody has
 */
public record BridgeStatus(String name, BridgeEnd from, BridgeEnd to, State state, String text, Counts counts,
    double rateHz, double lagSeconds, Optional<String> holder) {
  /** How a bridge is doing. */
  public enum State {
    /** One of its ends is not there, or nothing has come yet. */
    WAITING,
    /** Values pass. */
    CARRYING,
    /** Values come, and the last one was refused. */
    REFUSED,
    /** It cannot work as it is configured. */
    WRONG
  }

  /**
   * What has become of values.
   *
   * @param received taken from the robot that says them
   * @param passed handed on
   * @param thinned left out on purpose: by the rate, or as a newer one came
   * @param dropped lost to full queues, here or on the way here
   * @param refused not taken by the other side
   */
  public record Counts(long received, long passed, long thinned, long dropped, long refused) {
    /** Nothing yet. */
    public static final Counts NONE = new Counts(0, 0, 0, 0, 0);
  }
}
