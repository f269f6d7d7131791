package org.robotui.architecture.tests;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The source tree under test. */
record Repository(Path root, List<Bundle> bundles, Layers layers) {

  static Repository at(Path root) {
    return new Repository(root, bundlesIn(root.resolve("bundles")), Layers.read(root.resolve("bundles/LAYERS")));
  }

  /** The bundle that a package belongs to: the one with the longest name that the package starts with. */
  Optional<Bundle> owner(String packageOrType) {
    return bundles.stream()
        .filter(bundle -> (packageOrType + ".").startsWith(bundle.name() + "."))
        .max(Comparator.comparingInt(bundle -> bundle.name().length()));
  }

  /** All sources of all bundles, tests included. */
  Stream<SourceFile> sources() {
    return bundles.stream().flatMap(bundle -> bundle.allSources().stream());
  }

  String read(String path) {
    return Trees.read(root.resolve(path));
  }

  /** The feature.xml files. */
  List<Path> features() {
    Path folder = root.resolve("features");
    return Files.isDirectory(folder) ? Trees.files(folder, "feature.xml") : List.of();
  }

  private static List<Bundle> bundlesIn(Path folder) {
    try (Stream<Path> children = Files.list(folder)) {
      return children.filter(child -> Files.exists(child.resolve("META-INF/MANIFEST.MF"))).sorted().map(Bundle::at)
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
