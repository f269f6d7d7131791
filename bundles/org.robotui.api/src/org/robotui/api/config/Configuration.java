package org.robotui.api.config;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The file of a configuration, before anything is known of what is in it. */
public final class Configuration {
  /** The most bytes of a configuration: 1 MiB. */
  public static final long MOST_BYTES = 1 << 20;

  private Configuration() {}

  /**
   * Reads a configuration.
   *
   * @param file which
   * @return its text
   * @throws IOException where it is no text that can be read, as {@link NamedFile#text}
   */
  public static String read(Path file) throws IOException {
    return NamedFile.text(file, MOST_BYTES);
  }

  /**
   * Why a file can be no configuration, whatever is in it.
   *
   * @param file which
   * @return a sentence for users, or nothing where there is a text to be read
   */
  public static Optional<String> unreadable(Path file) {
    try {
      read(file);
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(Files.exists(file) ? "the file " + file + " " + e.getMessage() : "there is no file " + file);
    }
  }
}
