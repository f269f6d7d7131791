package org.robotui.recording;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Map;
import org.robotui.recording.internal.mcap.McapWriter;

/**
 * Writes a recording as MCAP. Any thread may use it. What was written stays in memory until its chunk is full or old
 * enough ({@link WriterOptions}); from then on it is the system's, and survives the end of this process. A file that
 * was not closed has no index, and can be read all the same.
 *
 * <p>Where the disk is full or broken, the file ends with the last record that was whole, and all later calls fail. So
 * do they where a thread is interrupted while it writes.
 */
public interface RecordingWriter extends AutoCloseable {

  /**
   * Starts a recording.
   *
   * @param file it; one that is there is replaced
   * @param options how it is written
   * @return the writer; who creates it closes it
   * @throws RecordingException if it cannot be written
   */
  static RecordingWriter create(Path file, WriterOptions options) throws RecordingException {
    return McapWriter.create(file, options);
  }

  /**
   * Adds a channel. It is in the file from its first message on.
   *
   * @param topic the name that messages are sent by; several channels may have one
   * @param messageEncoding how the bytes of messages are to be read, such as {@code cdr}
   * @param schema the type of messages; {@link RecordedSchema#NONE} where it is not known
   * @param metadata what else is to be noted of it
   * @return the channel, for {@link #write}
   * @throws IllegalStateException if there are 65535 already
   */
  RecordedChannel channel(String topic, String messageEncoding, RecordedSchema schema,
      Map<String, String> metadata);

  /**
   * Writes a message.
   *
   * @param channel of this writer
   * @param logTime when it was received, nanoseconds since 1970
   * @param publishTime when it was sent, nanoseconds since 1970; the log time where that is not known
   * @param sequence its number, 0 to 2^32 - 1; 0 where it has none
   * @param data its bytes, from position to limit; copied
   * @throws RecordingException if this or something before could not be written
   * @throws IllegalArgumentException if the channel is of another writer, or the message has more than 64 MiB
   * @throws IllegalStateException if the writer is closed
   */
  void write(RecordedChannel channel, long logTime, long publishTime, long sequence, ByteBuffer data)
      throws RecordingException;

  /**
   * Adds a file.
   *
   * @param name what it is called
   * @param mediaType such as {@code text/plain}
   * @param logTime when it was added, nanoseconds since 1970
   * @param createTime when it was made, nanoseconds since 1970; 0 where that is not known
   * @param content its bytes, from position to limit
   * @throws RecordingException if this or something before could not be written
   * @throws IllegalArgumentException if it has more than 64 MiB
   */
  void attach(String name, String mediaType, long logTime, long createTime, ByteBuffer content)
      throws RecordingException;

  /**
   * Adds notes.
   *
   * @param metadata the notes
   * @throws RecordingException if this or something before could not be written
   */
  void note(RecordedMetadata metadata) throws RecordingException;

  /**
   * Gives everything to the system, so that it survives the end of this process.
   *
   * @throws RecordingException if this or something before could not be written
   */
  void flush() throws RecordingException;

  /**
   * How long the file is so far.
   *
   * @return bytes, without the chunk that is being filled
   */
  long size();

  /**
   * Writes the rest and the index. A second call does nothing.
   *
   * @throws RecordingException if this or something before could not be written; the file is closed all the same
   */
  @Override
  void close() throws RecordingException;
}
