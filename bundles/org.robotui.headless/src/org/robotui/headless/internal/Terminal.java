package org.robotui.headless.internal;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The terminal behind the standard output, asked with the tools that every POSIX system has. */
final class Terminal {
  private static final Logger LOG = LoggerFactory.getLogger(Terminal.class);
  private static final File TTY = new File("/dev/tty");

  /**
   * A size in characters.
   *
   * @param columns the width
   * @param rows the height
   */
  record Size(int columns, int rows) {
    static final Size USUAL = new Size(80, 24);
  }

  /** Whether the standard output goes to a terminal; {@link System#console} no longer tells. */
  boolean isInteractive() {
    return run(new ProcessBuilder("test", "-t", "1").redirectOutput(ProcessBuilder.Redirect.INHERIT)).isPresent();
  }

  Size size() {
    return run(new ProcessBuilder("stty", "size").redirectInput(TTY)).flatMap(Terminal::parse).orElse(Size.USUAL);
  }

  static Optional<Size> parse(String rowsAndColumns) {
    String[] words = rowsAndColumns.strip().split(" ");
    try {
      Size size = new Size(Integer.parseInt(words[1]), Integer.parseInt(words[0]));
      return size.columns() > 0 && size.rows() > 0 ? Optional.of(size) : Optional.empty();
    } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
      return Optional.empty();
    }
  }

  private static Optional<String> run(ProcessBuilder builder) {
    try {
      Process process = builder.redirectError(ProcessBuilder.Redirect.DISCARD).start();
      return finish(process);
    } catch (IOException e) {
      LOG.debug("{} cannot be run", builder.command(), e);
      return Optional.empty();
    }
  }

  private static Optional<String> finish(Process process) throws IOException {
    try (InputStream output = process.getInputStream()) {
      String text = new String(output.readNBytes(100), StandardCharsets.US_ASCII);
      boolean fine = process.waitFor(1, TimeUnit.SECONDS) && process.exitValue() == 0;
      return fine ? Optional.of(text) : Optional.empty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    } finally {
      process.destroy();
    }
  }
}
