package org.robotui.rfic.recording.internal.lines;

import java.util.List;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;

/** What the lines of a log mean. A line that was read once means the same when it is read again. */
interface LineFormat {
  /** What kind of log it is, for users. */
  String name();

  /**
   * Reads a line.
   *
   * @param line without its end
   * @return its messages, none for a comment
   * @throws IllegalArgumentException if it is no line of such a log
   */
  List<RecordedMessage> messages(String line);

  /** The channels of all messages that were read so far. */
  List<RecordedChannel> channels();
}
