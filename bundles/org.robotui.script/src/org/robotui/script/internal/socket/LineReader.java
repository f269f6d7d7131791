package org.robotui.script.internal.socket;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** Reads lines that somebody else sends, each at most so long. One thread. */
final class LineReader {
  /** A line was too long. */
  static final class TooLongException extends IOException {
    private static final long serialVersionUID = 1L;

    TooLongException(int most) {
      super("a line has more than " + most + " bytes");
    }
  }

  private static final int ROOM = 8192;

  private final ReadableByteChannel channel;
  private final int most;
  private final ByteBuffer read = ByteBuffer.allocate(ROOM).flip();

  LineReader(ReadableByteChannel channel, int most) {
    this.channel = channel;
    this.most = most;
  }

  /** The next line without its end; nothing at the end, and for what is not ended by then. */
  Optional<String> next() throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    while (more()) {
      byte b = read.get();
      if (b == '\n') {
        return Optional.of(line.toString(StandardCharsets.UTF_8));
      }
      if (line.size() == most) {
        throw new TooLongException(most);
      }
      line.write(b);
    }
    return Optional.empty();
  }

  private boolean more() throws IOException {
    int count = 0;
    while (!read.hasRemaining() && count >= 0) {
      read.clear();
      count = channel.read(read);
      read.flip();
    }
    return read.hasRemaining();
  }
}
