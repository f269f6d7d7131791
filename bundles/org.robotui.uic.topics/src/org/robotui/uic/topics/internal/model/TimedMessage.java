package org.robotui.uic.topics.internal.model;

import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * A message of a recording, without its content: rows are many, and contents may be large.
 *
 * @param time when it was recorded, nanoseconds since 1970
 * @param place among the messages of the same time, from 0
 * @param gap nanoseconds since the message before it; none of the first one
 * @param size how many bytes it has, where that is known
 */
public record TimedMessage(long time, int place, OptionalLong gap, OptionalInt size) {
  /** What identifies it in its topic. */
  public String key() {
    return time + "/" + place;
  }
}
