package org.robotui.player.log;

import java.io.Closeable;
import java.io.IOException;
import java.io.Writer;
import java.util.Optional;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** Writes a log file, message by message, which Player's driver {@code readlog} can play. For one thread. */
public final class LogWriter implements Closeable {

  private static final String HEAD = """
      ## Player version %s\s
      ## File version 0.3.0\s
      ## Format:\s
      ## - Messages are newline-separated
      ## - Common header to each message is:
      ##   time     host   robot  interface index  type   subtype
      ##   (double) (uint) (uint) (string)  (uint) (uint) (uint)
      ## - Following the common header is the message payload\s
      """;

  private final Writer out;
  private final LogFormat format;

  /**
   * Begins a file.
   *
   * @param out the file, buffered
   * @param format knows the lines
   * @param version of the server, as it greets
   * @throws IOException if the file cannot be written
   */
  public LogWriter(Writer out, LogFormat format, String version) throws IOException {
    this.out = out;
    this.format = format;
    out.write(String.format(HEAD, version));
  }

  /**
   * Writes a message.
   *
   * @param message the message
   * @return false if log files have no line for such messages
   * @throws IOException if the file cannot be written
   * @throws PlayerException if the message's body is not valid
   */
  public boolean write(PlayerMessage message) throws IOException, PlayerException {
    Optional<String> line = format.line(message);
    if (line.isPresent()) {
      out.write(line.get());
      out.write('\n');
    }
    return line.isPresent();
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
