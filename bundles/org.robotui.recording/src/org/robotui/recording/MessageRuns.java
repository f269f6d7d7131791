package org.robotui.recording;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * A file of a format that is not known here, cut into runs of messages that lie one after another.
 * {@link Recordings#of} makes a recording of it, which brings messages into order, finds the newest ones, and keeps
 * those that were read in a bounded memory. Runs are read one at a time, by any thread.
 */
public interface MessageRuns extends AutoCloseable {

  /**
   * Some messages.
   *
   * @param start the earliest of their log times, nanoseconds since 1970
   * @param end the latest one
   * @param counts how many there are by the number of their channel; no channel without one
   */
  record Run(long start, long end, Map<Integer, Long> counts) {

    /** As the components say; the counts are copied. */
    public Run {
      counts = Map.copyOf(counts);
      if (end < start) {
        throw new IllegalArgumentException("a run from " + start + " to " + end);
      }
    }
  }

  /**
   * The file.
   *
   * @return as it was opened
   */
  Path file();

  /**
   * What kind of file it is.
   *
   * @return a word or two, for users
   */
  String format();

  /**
   * What was recorded.
   *
   * @return channels, each with a number of its own
   */
  List<RecordedChannel> channels();

  /**
   * All messages: some megabytes each, so that one costs little to be read.
   *
   * @return in the order of the file
   */
  List<Run> runs();

  /**
   * Reads messages.
   *
   * @param run which of {@link #runs}
   * @return its messages in the order of the file; of a damaged one those that are whole
   * @throws RecordingException if the file cannot be read any more
   */
  List<RecordedMessage> read(int run) throws RecordingException;

  /**
   * What could not be read so far.
   *
   * @return by their places
   */
  List<RecordingDamage> damages();

  /** Closes the file. */
  @Override
  void close();
}
