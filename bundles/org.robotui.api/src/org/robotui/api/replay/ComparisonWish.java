package org.robotui.api.replay;

/**
 * What of two recordings is compared, and how.
 *
 * @param first the recording that is taken for right
 * @param second the one that is compared with it
 * @param topic a topic that says where the robot was, such as {@code odom}; one of each recording where names differ,
 * such as {@code truth,odom}; or one with the path of a number, such as {@code odom linear.x}
 * @param pairing which times belong together
 * @param alignment how the second way is moved onto the first
 */
public record ComparisonWish(TrackId first, TrackId second, String topic, Pairing pairing, Alignment alignment) {
  /** Which times of two recordings belong together. */
  public enum Pairing {
    /** Times of the timeline, with the offsets of the recordings. */
    TIME,
    /** Times since the first value. */
    START,
    /** Where the same way was gone; for ways alone. */
    WAY
  }

  /** How the second way is moved onto the first before both are compared. */
  public enum Alignment {
    /** It stays where it is. */
    NONE,
    /** Its first pose becomes that of the other. */
    ORIGIN,
    /** Moved, and turned around the vertical axis, so that the squares of distances are least. */
    YAW,
    /** Moved and turned in any way, so that the squares of distances are least. */
    SE3
  }
}
