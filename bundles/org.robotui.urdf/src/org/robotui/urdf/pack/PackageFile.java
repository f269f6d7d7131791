package org.robotui.urdf.pack;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** What a URI names. */
public sealed interface PackageFile {
  /**
   * A file.
   *
   * @param file where it really lies
   * @param folder of its package, which it lies in
   */
  record Found(Path file, Path folder) implements PackageFile {
    private static final int MOST_BYTES = 512 << 20;

    /**
     * Reads all of it. Blocks.
     *
     * @return its bytes, 512 MB at most
     * @throws IOException where it cannot be read, or grew too large
     */
    public byte[] bytes() throws IOException {
      try (InputStream in = Files.newInputStream(file)) {
        byte[] bytes = in.readNBytes(MOST_BYTES);
        if (in.read() >= 0) {
          throw new IOException(file + " has more than " + MOST_BYTES + " bytes");
        }
        return bytes;
      }
    }
  }

  /**
   * It is not read.
   *
   * @param why the reason, and what would help
   */
  record Refused(String why) implements PackageFile {}

  /**
   * The file, where there is one.
   *
   * @return the file, or none
   */
  default Optional<Found> found() {
    return this instanceof Found file ? Optional.of(file) : Optional.empty();
  }
}
