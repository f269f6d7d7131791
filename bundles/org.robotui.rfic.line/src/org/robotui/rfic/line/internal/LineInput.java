package org.robotui.rfic.line.internal;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** Reads lines of text from a peer that is not trusted: their length has a bound. */
final class LineInput {

  private static final int LONGEST = 256;

  private final InputStream in;

  LineInput(InputStream in) {
    this.in = new BufferedInputStream(in);
  }

  /**
   * Blocks until there is a line.
   *
   * @return the line, without its end; none where the peer has closed the connection
   * @throws IOException where a line is too long, or the connection breaks
   */
  Optional<String> next() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    for (int next = in.read(); next != '\n'; next = in.read()) {
      if (next < 0) {
        return Optional.empty();
      }
      if (bytes.size() == LONGEST) {
        throw new IOException("the robot says a line of more than " + LONGEST + " bytes");
      }
      bytes.write(next);
    }
    return Optional.of(bytes.toString(StandardCharsets.UTF_8));
  }
}
