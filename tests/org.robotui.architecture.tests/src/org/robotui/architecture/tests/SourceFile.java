package org.robotui.architecture.tests;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;

/**
 * One Java file: where it lies under its source folder, its text, and its syntax tree, which is made when it is wanted.
 */
final class SourceFile {

  private final Path folder;
  private final Path path;
  private final String text;
  private ParsedSource parsed;
  private Set<String> qualifiedNames;

  SourceFile(Path folder, Path path, String text) {
    this.folder = folder;
    this.path = path;
    this.text = text;
  }

  static List<SourceFile> allIn(Path folder) {
    return Trees.files(folder, ".java").stream()
        .map(file -> new SourceFile(folder, file, Trees.read(file)))
        .toList();
  }

  /** The package that the folder stands for, as in "org.robotui.data". */
  String folderPackage() {
    Path parent = folder.relativize(path).getParent();
    return parent == null ? "" : parent.toString().replace('/', '.');
  }

  /** Bundle, source folder and path: what a reader needs to find it. */
  String where() {
    return folder.getParent().getParent().relativize(path).toString();
  }

  String fileName() {
    return path.getFileName().toString();
  }

  String text() {
    return text;
  }

  long lines() {
    return text.lines().count();
  }

  ParsedSource parsed() {
    if (parsed == null) {
      parsed = ParsedSource.of(this);
    }
    return parsed;
  }

  /** All qualified names in imports and code, as written. */
  Set<String> qualifiedNames() {
    if (qualifiedNames == null) {
      qualifiedNames = parsed().qualifiedNames();
    }
    return qualifiedNames;
  }
}
