package org.robotui.ros.bag;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

import org.junit.jupiter.api.Assumptions;

/** Finds the recordings that are shared beside the repository; tests that need one are skipped without it. */
final class SharedData {

    private SharedData() {
    }

    static Path bag(String name) {
        Optional<Path> found = root().map(root -> root.resolve("data/bags").resolve(name)).filter(Files::isReadable);
        Assumptions.assumeTrue(found.isPresent(), "no shared recording " + name + " (set ROBOTUI_SHARED)");
        return found.orElseThrow();
    }

    private static Optional<Path> root() {
        String configured = System.getenv("ROBOTUI_SHARED");
        return configured != null
                ? Optional.of(Path.of(configured))
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
