package org.robotui.core.internal.stop;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.robotui.api.config.AtomicFile;

/** Files that only their user can read. */
final class PrivateFiles {
  private PrivateFiles() {}

  /** Makes a folder where there is none; closes it to others. */
  static void folder(Path folder) throws IOException {
    Files.createDirectories(folder);
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwx------"));
  }

  /** Writes a text as a whole: who reads it finds all or nothing. */
  static void write(Path file, String text) throws IOException {
    folder(file.getParent());
    AtomicFile.writePrivate(file, text);
  }
}
