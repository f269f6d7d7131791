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
import java.nio.file.attribute.PosixFileAttributeView;
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
   * Writes what is given piece by piece. A file that is replaced keeps its rights; where it is a link, what it leads to
   * is replaced. What is no file, such as a device or a pipe, is written to directly.
   *
   * @param file is replaced where it exists
   * @param content the whole
   * @throws IOException where it cannot be written; {@link WriteFailure} has words for users
   */
  public static void write(Path file, Content content) throws IOException {
    if (Files.exists(file) && !Files.isRegularFile(file)) {
      stream(file, content, StandardOpenOption.WRITE);
      return;
    }
    if (Files.exists(file) && !Files.isWritable(file)) {
      throw new AccessDeniedException(file.toString());
    }
    Path place = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
    Path next = place.resolveSibling("." + place.getFileName() + "." + UUID.randomUUID() + ".new");
    try {
      stream(next, content, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
      keepRights(place, next);
      Files.move(next, place, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(next);
    }
  }

  private static void stream(Path file, Content content, StandardOpenOption... how) throws IOException {
    try (OutputStream out = Files.newOutputStream(file, how)) {
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
