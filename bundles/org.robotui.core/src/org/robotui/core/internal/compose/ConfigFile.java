package org.robotui.core.internal.compose;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.util.Optional;
import org.robotui.api.config.AtomicFile;

/**
 * The file into which a RUIC is written.
 *
 * @param path as the user named it
 */
record ConfigFile(Path path) {
  private static final long MAX_BYTES = 1 << 20;

  /** Why nothing can be written there, empty where it can. */
  Optional<String> obstacle() {
    Path folder = folder();
    String name = Optional.ofNullable(path.getFileName()).map(Path::toString).orElse("");
    if (!name.endsWith(".yaml") && !name.endsWith(".yml")) {
      return Optional
          .of("a configuration's name ends with .yaml; write " + (name.isEmpty() ? "robot" : name) + ".yaml");
    }
    if (!Files.isDirectory(folder)) {
      return Optional.of("there is no folder " + folder + "; make it, or choose another one");
    }
    if (Files.isDirectory(path)) {
      return Optional.of(path + " is a folder; name a file in it");
    }
    return Files.isWritable(folder) && (!Files.exists(path) || Files.isWritable(path)) ? Optional.empty()
        : Optional.of((Files.exists(path) ? path : folder) + " is not yours to write; choose another place");
  }

  boolean isThere() {
    return Files.exists(path);
  }

  /** What stands in it; throws with a sentence. */
  String read() throws IOException {
    try {
      if (Files.size(path) > MAX_BYTES) {
        throw new IOException(path + " is larger than a configuration can be (" + MAX_BYTES + " bytes)");
      }
      return Files.readString(path);
    } catch (CharacterCodingException e) {
      throw new IOException(path + " is no UTF-8 text", e);
    }
  }

  /** A new file; throws {@link FileAlreadyExistsException} where somebody else was quicker. */
  void create(String text) throws IOException {
    Path next = beside(text);
    try {
      Files.createLink(path, next);
    } catch (UnsupportedOperationException e) {
      Files.move(next, path);
    } finally {
      Files.deleteIfExists(next);
    }
  }

  /** In place of what stands there, with the same rights; where it is a link, behind it. */
  void replace(String text) throws IOException {
    AtomicFile.write(path.toRealPath(), text);
  }

  private Path beside(String text) throws IOException {
    Path next = Files.createTempFile(folder(), "." + path.getFileName(), ".new");
    try {
      Files.writeString(next, text);
    } catch (IOException e) {
      Files.deleteIfExists(next);
      throw e;
    }
    Optional<PosixFileAttributeView> view = rights(next);
    if (view.isPresent()) {
      view.get().setPermissions(java.nio.file.attribute.PosixFilePermissions.fromString("rw-r--r--"));
    }
    return next;
  }

  private static Optional<PosixFileAttributeView> rights(Path file) {
    return Optional.ofNullable(Files.getFileAttributeView(file, PosixFileAttributeView.class));
  }

  private Path folder() {
    Path absolute = path.toAbsolutePath();
    return Optional.ofNullable(absolute.getParent()).orElse(absolute);
  }
}
