package org.robotui.rfic.recording.internal.export;

import java.math.BigDecimal;
import org.robotui.data.record.DynamicRecord;

/** The messages of a channel as lines. For one thread. */
interface MessageLines {
  /** Whether all messages must be seen before the first line. */
  boolean learns();

  /** Sees a message. */
  void learn(DynamicRecord message);

  /** What comes before all lines, with the end of its line; empty for nothing. */
  String head();

  /**
   * A message in a line.
   *
   * @param time nanoseconds since 1970
   * @param elapsed nanoseconds since the start of the recording
   */
  String line(long time, long elapsed, DynamicRecord message);

  /** What about them users should know; empty for nothing. */
  String note();

  /** A time with all its digits. */
  static String seconds(long nanos) {
    return BigDecimal.valueOf(nanos, 9).toPlainString();
  }
}
