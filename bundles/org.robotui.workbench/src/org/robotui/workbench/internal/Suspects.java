package org.robotui.workbench.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The bundles that held the display up in the last run: core's watchdog names them in a file, one a line. Where it
 * could blame no single view it names a bundle that nothing works without; nobody is asked about those.
 */
public final class Suspects {
  private static final Logger LOG = LoggerFactory.getLogger(Suspects.class);
  private static final String FILE = "suspect-bundles.txt";
  private static final Set<String> NEEDED =
      Set.of("org.robotui.workbench", "org.robotui.ui", "org.robotui.core", "org.robotui.api",
          "org.robotui.data", "org.robotui.geometry");

  private final Path file;

  /** In the folder of the user's state. */
  public Suspects(Path folder) {
    file = folder.resolve(FILE);
  }

  /** Whether there is anybody to ask about. */
  public boolean exist() {
    return Files.exists(file);
  }

  /** Asks for each suspect once whether to leave it out, and forgets them. */
  public List<String> judge(Predicate<String> leaveOut) {
    List<String> out = read().stream().filter(bundle -> !NEEDED.contains(bundle)).filter(leaveOut).toList();
    forget();
    return out;
  }

  private List<String> read() {
    try {
      return Files.exists(file) ? Files.readAllLines(file).stream().filter(l -> !l.isBlank()).distinct().toList()
          : List.of();
    } catch (IOException e) {
      LOG.warn("{} cannot be read: {}", file, e.toString());
      return List.of();
    }
  }

  private void forget() {
    try {
      Files.deleteIfExists(file);
    } catch (IOException e) {
      LOG.warn("{} cannot be deleted, so that the same question comes again: {}", file, e.toString());
    }
  }
}
