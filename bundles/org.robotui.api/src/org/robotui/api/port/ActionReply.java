package org.robotui.api.port;

import java.util.Optional;
import org.robotui.data.record.DynamicRecord;

/**
 * How such a task ended.
 *
 * @param end how
 * @param text what the robot says of it, may be empty
 * @param result the fields of the result, where there is one
 */
public record ActionReply(End end, String text, Optional<DynamicRecord> result) {
  /** How a task ends. */
  public enum End {
    /** As it was meant. */
    SUCCEEDED,
    /** The robot gave up. */
    ABORTED,
    /** The robot did not take it. */
    REJECTED,
    /** It was cancelled, or another took its place. */
    PREEMPTED,
    /** It was cancelled before it began. */
    RECALLED,
    /** Nobody knows: the robot says no more of it. */
    LOST
  }
}
