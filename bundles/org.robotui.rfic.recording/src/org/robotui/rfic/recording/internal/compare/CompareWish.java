package org.robotui.rfic.recording.internal.compare;

import java.util.Optional;

/**
 * How two recordings are compared.
 *
 * @param topic what of them
 * @param pairing which times belong together
 * @param fit how the second way is moved onto the first
 * @param step over which part of the way relative errors are taken
 * @param mostApart how far the times of two poses may be apart, in nanoseconds
 * @param offset what is added to the times of the second recording, in nanoseconds, after they are paired
 */
public record CompareWish(ComparedTopic topic, Pairing pairing, PoseFit fit, RelativeStep step, long mostApart,
    long offset) {
  /** Ten milliseconds, as of evo. */
  public static final long MOST_APART = 10_000_000L;

  /** Which times of two recordings belong together. */
  public sealed interface Pairing {
    /** Times of the clock. */
    record Clock() implements Pairing {}

    /** Times since the first message of what is compared. */
    record Start() implements Pairing {}

    /**
     * Times since a condition held for the first time.
     *
     * @param condition as of alerts
     */
    record Event(String condition) implements Pairing {}

    /**
     * Where the same way was gone.
     *
     * @param topic says where the robot was; none for what is compared
     */
    record Gone(Optional<ComparedTopic> topic) implements Pairing {
      /** The way that is compared. */
      public static final Gone SAME = new Gone(Optional.empty());
    }
  }
}
