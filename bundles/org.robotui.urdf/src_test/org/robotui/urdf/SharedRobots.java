package org.robotui.urdf;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;

/** Finds the models that are shared beside the repository; tests that need them are skipped without. */
final class SharedRobots {
  private SharedRobots() {}

  static Path folder() {
    Optional<Path> found = root().map(root -> root.resolve("data/robots")).filter(Files::isDirectory);
    Assumptions.assumeTrue(found.isPresent(), "no shared models of robots (set ROBOTUI_SHARED)");
    return found.orElseThrow();
  }

  static List<Path> all(String ending) {
    try (Stream<Path> files = Files.walk(folder())) {
      return files.filter(file -> file.toString().endsWith(ending)).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static String text(String path) {
    try {
      return Files.readString(folder().resolve(path));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Optional<Path> root() {
    String configured = System.getenv("ROBOTUI_SHARED");
    return configured != null ? Optional.of(Path.of(configured))
        : repository().map(repository -> repository.resolveSibling("shared"));
  }

  private static Optional<Path> repository() {
    Path folder = Path.of("").toAbsolutePath();
    while (folder != null && !Files.isDirectory(folder.resolve("bundles"))) {
      folder = folder.getParent();
    }
    return Optional.ofNullable(folder);
  }
}
