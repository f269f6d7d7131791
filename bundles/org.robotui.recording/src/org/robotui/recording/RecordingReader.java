package org.robotui.recording;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A recording that is open for reading. Any thread may use it, several at once. What it keeps of the file's messages is
 * bounded, whatever the size of the file; of its index it keeps some hundred bytes for each chunk.
 */
public interface RecordingReader extends AutoCloseable {

  /**
   * The file.
   *
   * @return as it was opened
   */
  Path file();

  /**
   * What kind of file it is.
   *
   * @return such as {@code mcap} or {@code rosbag 2.0}
   */
  String format();

  /**
   * Whether the file has an index of its own that could be used.
   *
   * @return false where it had to be read through when it was opened
   */
  boolean isIndexed();

  /**
   * What was recorded.
   *
   * @return by their numbers
   */
  List<RecordedChannel> channels();

  /**
   * From the first to the last message, by log time.
   *
   * @return empty where there is no message
   */
  Optional<RecordingInterval> span();

  /**
   * How many messages there are, as the index says: fewer can be read of a damaged file.
   *
   * @return by the number of the channel; channels without a message may be missing
   */
  Map<Integer, Long> messageCounts();

  /**
   * The files that lie in it.
   *
   * @return in order of their places
   */
  List<RecordedAttachment> attachments();

  /**
   * Reads such a file.
   *
   * @param attachment one of {@link #attachments}
   * @return its bytes, at most some 256 MiB
   * @throws RecordingException if it cannot be read, is larger, or its checksum is wrong
   */
  ByteBuffer content(RecordedAttachment attachment) throws RecordingException;

  /**
   * What the recorder noted.
   *
   * @return in order of their places
   */
  List<RecordedMetadata> metadata();

  /**
   * What could not be read so far. A chunk of the file is looked at when it is needed, so that this grows.
   *
   * @return by their places; of very many the first ones alone
   */
  List<RecordingDamage> damages();

  /**
   * Messages of some channels from a time on.
   *
   * @param interval the log times
   * @param channels numbers of channels; empty for all
   * @return a cursor before the first of them; nothing is read before it is asked
   */
  RecordingCursor cursor(RecordingInterval interval, Set<Integer> channels);

  /**
   * The newest message of a channel at a time: what a view would show that had listened until then.
   *
   * @param channel the number of a channel
   * @param time nanoseconds since 1970; a message of this very time counts
   * @return empty where the channel had none by then
   * @throws RecordingException if the file cannot be read any more
   */
  Optional<RecordedMessage> latestBefore(int channel, long time) throws RecordingException;

  /** Closes the file. Cursors end with an exception then. */
  @Override
  void close();
}
