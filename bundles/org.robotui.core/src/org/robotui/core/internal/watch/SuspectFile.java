package org.robotui.core.internal.watch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Remembers bundles that held the display up, one symbolic name a line, so that the next start can offer to leave them
 * out. The application reads and clears it.
 */
public final class SuspectFile {
  private static final Logger LOG = LoggerFactory.getLogger(SuspectFile.class);

  private final Path file;

  /** Kept in a file that need not exist. */
  public SuspectFile(Path file) {
    this.file = file;
  }

  /** Adds a bundle, once. */
  public void add(String bundle) {
    try {
      if (!all().contains(bundle)) {
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.writeString(file, bundle + "\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
      }
    } catch (IOException e) {
      LOG.warn("{} cannot be written, so that the next start will not know of bundle {}: {}", file, bundle,
          e.toString());
    }
  }

  /** All bundles. */
  List<String> all() throws IOException {
    return Files.exists(file) ? Files.readAllLines(file) : List.of();
  }
}
