package org.robotui.uic.log.internal.model;

import org.robotui.data.status.Severity;

/**
 * A kept entry of the log.
 *
 * @param id counts the entries of this view
 * @param severity how bad
 * @param origin who says it
 * @param message the text, at most {@link Intake#LONGEST_MESSAGE} characters
 * @param location where in the code, may be empty
 * @param nanos when, since 1970 or since the start of a simulated clock
 * @param cut how many characters of the message were not kept
 */
public record Entry(long id, Severity severity, String origin, String message, String location, long nanos, int cut) {
  private static final int OBJECTS = 160;
  private static final int BYTES_PER_CHAR = 2;

  /** About how much memory it takes, names that many share left out. */
  public long bytes() {
    return OBJECTS + (long) BYTES_PER_CHAR * (message.length() + location.length());
  }

  /** Whether another says the same, whenever. */
  public boolean says(Entry other) {
    return severity == other.severity && origin.equals(other.origin) && message.equals(other.message);
  }

  /** The message up to its first line break, at most so many characters. */
  public String firstLine(int most) {
    int end = message.indexOf('\n');
    return message.substring(0, Math.min(end < 0 ? message.length() : end, most)).stripTrailing();
  }

  /** Whether {@link #firstLine} leaves something out. */
  public boolean more() {
    return message.stripTrailing().indexOf('\n') >= 0;
  }
}
