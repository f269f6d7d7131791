package org.robotui.architecture.tests;

import java.nio.file.Path;
import java.util.Set;

/** One Java file: where it lies under its source folder, its text, and its syntax tree. */
final class SourceFile {

  private final SourceFolder folder;
  private final Path path;
  private final String text;
  private Set<String> qualifiedNames;

  SourceFile(SourceFolder folder, Path path, String text) {
    this.folder = folder;
    this.path = path;
    this.text = text;
  }

  /** The package that the folder stands for, as in "org.robotui.data". */
  String folderPackage() {
    Path parent = folder.path().relativize(path).getParent();
    return parent == null ? "" : parent.toString().replace('/', '.');
  }

  /** Bundle, source folder and path: what a reader needs to find it. */
  String where() {
    return folder.path().getParent().getParent().relativize(path).toString();
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
    return folder.parsed(this);
  }

  /** All qualified names in imports and code, as written. */
  Set<String> qualifiedNames() {
    if (qualifiedNames == null) {
      qualifiedNames = parsed().qualifiedNames();
    }
    return qualifiedNames;
  }
}
