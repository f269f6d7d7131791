package org.robotui.architecture.tests;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** A folder of Java files. Their syntax trees are made together, when the first of them is wanted. */
final class SourceFolder {

  private final Path path;
  private final List<SourceFile> sources;
  private Map<SourceFile, ParsedSource> parsed = Map.of();

  SourceFolder(Path path) {
    this.path = path;
    this.sources =
        Trees.files(path, ".java").stream().map(file -> new SourceFile(this, file, Trees.read(file))).toList();
  }

  Path path() {
    return path;
  }

  List<SourceFile> sources() {
    return sources;
  }

  ParsedSource parsed(SourceFile source) {
    if (parsed.isEmpty()) {
      parsed = ParsedSource.of(sources);
    }
    return parsed.get(source);
  }
}
