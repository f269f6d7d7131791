package org.robotui.api.replay;

/**
 * How far the clocks of two recordings are apart, as far as that can be told.
 *
 * @param offset what is to be added to the times of the file that is moved, nanoseconds
 * @param deviation the standard deviation of the offset, nanoseconds
 * @param basis what it was found by, for users
 */
public record OffsetEstimate(long offset, long deviation, String basis) {
  /** Why there is none, for users. */
  public static final String NONE =
      "it cannot be told: the recordings share fewer than five messages, and nothing turned alike in them";
}
