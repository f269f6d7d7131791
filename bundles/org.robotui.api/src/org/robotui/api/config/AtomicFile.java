package org.robotui.api.config;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import java.util.UUID;

/**
 * Writes files that users ask for as a whole: beside their place first, so that a full disk or the end of the process
 * leaves what stood there before, never a part. Any thread; blocks.
 */
public final class AtomicFile {

  /** What a file shall hold. */
  @FunctionalInterface
  public interface Content {

    /**
     * Writes it.
     *
     * @param out is buffered by nobody, and closed by the caller
     * @throws IOException where it cannot be written; the file stays as it was
     */
    void writeTo(OutputStream out) throws IOException;
  }

  private AtomicFile() {}

  /**
   * Writes a text in UTF-8.
   *
   * @param file is replaced where it exists
   * @param text the whole
   * @throws IOException where it cannot be written; {@link WriteFailure} has words for users
   */
  public static void write(Path file, String text) throws IOException {
    write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }

  /**
   * Writes a text in UTF-8 that nobody but this user may read, whatever rights a file before it had. A folder that is
   * not there is made, and is closed to others as well. Where files have no such rights, it is written as any other.
   *
   * @param file is replaced where it exists
   * @param text the whole
   * @throws IOException where it cannot be written; {@link WriteFailure} has words for users
   */
  public static void writePrivate(Path file, String text) throws IOException {
    writePrivate(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }

  /**
   * Writes as {@link #writePrivate(Path, String)} what is given piece by piece.
   *
   * @param file is replaced where it exists
   * @param content the whole
   * @throws IOException where it cannot be written; {@link WriteFailure} has words for users
   */
  public static void writePrivate(Path file, Content content) throws IOException {
    Files.createDirectories(place(file).getParent(), rights(file, "rwx------"));
    write(file, content, rights(file, "rw-------"));
  }

  private static FileAttribute<?>[] rights(Path file, String rights) {
    return file.getFileSystem().supportedFileAttributeViews().contains("posix")
        ? new FileAttribute<?>[]{PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(rights))}
        : new FileAttribute<?>[0];
  }

  /**
   * Writes what is given piece by piece. A file that is replaced keeps its rights; where it is a link, what it leads to
   * is replaced. What is no file, such as a device or a pipe, is written to directly.
   *
   * @param file is replaced where it exists
   * @param content the whole
   * @throws IOException where it cannot be written; {@link WriteFailure} has words for users
   */
  public static void write(Path file, Content content) throws IOException {
    write(file, content, new FileAttribute<?>[0]);
  }

  /** With the given rights from the first byte on, or where none are given with those of the file before it. */
  private static void write(Path file, Content content, FileAttribute<?>... rights) throws IOException {
    if (Files.exists(file) && !Files.isRegularFile(file)) {
      stream(Files.newOutputStream(file, StandardOpenOption.WRITE), content);
      return;
    }
    if (Files.exists(file) && !Files.isWritable(file)) {
      throw new AccessDeniedException(file.toString());
    }
    Path place = place(file);
    Path next = place.resolveSibling("." + place.getFileName() + "." + UUID.randomUUID() + ".new");
    try {
      stream(Files.newOutputStream(Files.createFile(next, rights), StandardOpenOption.WRITE), content);
      if (rights.length == 0) {
        keepRights(place, next);
      }
      Files.move(next, place, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(next);
    }
  }

  private static Path place(Path file) throws IOException {
    return Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
  }

  private static void stream(OutputStream out, Content content) throws IOException {
    try (out) {
      content.writeTo(out);
    }
  }

  private static void keepRights(Path from, Path to) throws IOException {
    Optional<PosixFileAttributeView> rights =
        Optional.ofNullable(Files.getFileAttributeView(to, PosixFileAttributeView.class));
    if (rights.isPresent() && Files.exists(from, LinkOption.NOFOLLOW_LINKS)) {
      rights.get().setPermissions(Files.getPosixFilePermissions(from));
    }
  }
}
