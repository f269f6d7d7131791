package org.robotui.lcm.log;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** Writes logs that all LCM programs read. Any thread may use it. */
public final class EventLogWriter implements AutoCloseable {

  private final FileChannel file;
  private long number;

  private EventLogWriter(FileChannel file, long number) {
    this.file = file;
    this.number = number;
  }

  /**
   * Starts a log.
   *
   * @param path the file; one that is there is replaced
   * @return the writer
   * @throws IOException if it cannot be written; the message names it
   */
  public static EventLogWriter create(Path path) throws IOException {
    return open(path, 0, StandardOpenOption.TRUNCATE_EXISTING);
  }

  /**
   * Goes on with a log.
   *
   * @param path the file; it is made if it is not there
   * @return the writer, which counts on from the events that are there
   * @throws IOException if it cannot be read and written; the message names it
   */
  public static EventLogWriter append(Path path) throws IOException {
    return open(path, Files.exists(path) ? EventLogIndex.of(path).size() : 0, StandardOpenOption.APPEND);
  }

  private static EventLogWriter open(Path path, long number, StandardOpenOption how) throws IOException {
    try {
      return new EventLogWriter(FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.WRITE, how),
          number);
    } catch (IOException e) {
      throw new IOException(
          "the log " + path + " cannot be written: " + e.getMessage() + " (" + e.getClass().getSimpleName() + ")", e);
    }
  }

  /**
   * Writes an event. It is with the system when this returns.
   *
   * @param utime when it was received, microseconds since 1970
   * @param channel the channel
   * @param data its bytes, from position to limit
   * @throws IOException if it cannot be written
   * @throws IllegalArgumentException if the channel is empty or too long
   */
  public synchronized void write(long utime, String channel, ByteBuffer data) throws IOException {
    byte[] name = channel.getBytes(StandardCharsets.UTF_8);
    if (name.length == 0 || name.length > LogFormat.MOST_CHANNEL) {
      throw new IllegalArgumentException("a channel of " + name.length + " bytes");
    }
    ByteBuffer body = data.duplicate();
    ByteBuffer header =
        ByteBuffer.allocate(LogFormat.HEADER + name.length).putInt(LogFormat.SYNC).putLong(number).putLong(utime)
            .putInt(name.length).putInt(body.remaining()).put(name).flip();
    ByteBuffer[] all = {header, body};
    while (header.hasRemaining() || body.hasRemaining()) {
      file.write(all);
    }
    number++;
  }

  /**
   * How many events the log has.
   *
   * @return the number of the next event
   */
  public synchronized long size() {
    return number;
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
