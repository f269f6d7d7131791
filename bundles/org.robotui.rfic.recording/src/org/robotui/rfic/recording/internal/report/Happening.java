package org.robotui.rfic.recording.internal.report;

import org.robotui.data.status.Severity;

/**
 * Something that a recording says of how the robot was doing.
 *
 * @param time when it was said first
 * @param severity how bad it is
 * @param source who said it
 * @param words what
 * @param times how often it was said
 */
record Happening(long time, Severity severity, String source, String words, long times) {
  boolean saysAs(Happening other) {
    return severity == other.severity && source.equals(other.source) && words.equals(other.words);
  }

  Happening again() {
    return new Happening(time, severity, source, words, times + 1);
  }
}
