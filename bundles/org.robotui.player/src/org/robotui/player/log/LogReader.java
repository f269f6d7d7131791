package org.robotui.player.log;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.Reader;
import java.util.Optional;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** Reads a log file, message by message. For one thread. */
public final class LogReader implements Closeable {

  /** A picture of Player's greatest message in hexadecimal digits, and some. */
  private static final int LONGEST = 3 * PlayerMessage.MAX_BYTES;

  private final Reader in;
  private final LogFormat format;
  private long number;
  private long unknown;

  /**
   * Creates a reader.
   *
   * @param in the file, buffered
   * @param format knows the lines
   */
  public LogReader(Reader in, LogFormat format) {
    this.in = in;
    this.format = format;
  }

  /**
   * Reads the next message whose kind is known.
   *
   * @return empty at the end of the file
   * @throws IOException if the file cannot be read
   * @throws PlayerException if a line is none of a log file; names the line's number. The next call goes on behind it
   */
  public Optional<PlayerMessage> next() throws IOException, PlayerException {
    while (true) {
      String line;
      try {
        line = line();
      } catch (EOFException e) {
        return Optional.empty();
      }
      Optional<PlayerMessage> message = line.isBlank() || line.startsWith("#") ? Optional.empty() : message(line);
      if (message.isPresent()) {
        return message;
      }
    }
  }

  private Optional<PlayerMessage> message(String line) throws PlayerException {
    try {
      Optional<PlayerMessage> message = format.message(line);
      unknown += message.isEmpty() ? 1 : 0;
      return message;
    } catch (PlayerException e) {
      throw e.within("line " + number);
    }
  }

  /**
   * How many messages were passed over as nothing is known of their kind.
   *
   * @return so far
   */
  public long unknown() {
    return unknown;
  }

  private String line() throws IOException, PlayerException {
    StringBuilder line = new StringBuilder();
    number++;
    for (int next = in.read(); next != '\n'; next = in.read()) {
      if (next < 0) {
        if (line.isEmpty()) {
          throw new EOFException("the file ends");
        }
        return line.toString();
      }
      if (line.length() >= LONGEST) {
        throw new PlayerException("line " + number + ": longer than any message can be");
      }
      line.append((char) next);
    }
    return line.toString();
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
