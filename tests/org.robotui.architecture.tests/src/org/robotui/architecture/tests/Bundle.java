package org.robotui.architecture.tests;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.Manifest;
import java.util.stream.Stream;

/** One bundle: its folder's name, its manifest, its sources and its unit tests. */
record Bundle(String name, ManifestHeaders manifest, List<SourceFile> sources, List<SourceFile> tests) {

  static Bundle at(Path folder) {
    return new Bundle(folder.getFileName().toString(), manifestOf(folder),
        new SourceFolder(folder.resolve("src")).sources(), new SourceFolder(folder.resolve("src_test")).sources());
  }

  List<SourceFile> allSources() {
    return Stream.concat(sources.stream(), tests.stream()).toList();
  }

  /** Whether the name is this one, or starts so when the pattern ends in a star. */
  boolean matches(String pattern) {
    return Layers.matches(pattern, name);
  }

  private static ManifestHeaders manifestOf(Path folder) {
    try (InputStream in = Files.newInputStream(folder.resolve("META-INF/MANIFEST.MF"))) {
      return new ManifestHeaders(new Manifest(in));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
