package org.robotui.recorder.internal.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.WriteFailure;

/** Where recordings lie: how much room there is, and whether they can be written. */
public class Disk {
  /** With less, nothing is begun. */
  static final long LEAST_TO_BEGIN = 100L << 20;
  /** With less, a recording is ended while its index can still be written. */
  static final long LEAST_TO_GO_ON = 32L << 20;
  /** With less, it is said that it will end. */
  static final long LITTLE = 1L << 30;

  private static final String EXTENSION = ".mcap";
  private static final DateTimeFormatter NAME = DateTimeFormatter.ofPattern("yyyy-MM-dd_HH-mm-ss", Locale.ROOT);

  /**
   * How many bytes are left in a folder.
   *
   * @param folder which
   * @return bytes
   * @throws IOException where that cannot be told
   */
  protected long left(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      throw new NotDirectoryException(folder.toString());
    }
    return folder.toFile().getUsableSpace(); // a file store needs the list of mounts, which not every container has
  }

  /** The file that is meant: in a folder it is named by the time. */
  static Path file(Path target, String word) {
    Path absolute = target.toAbsolutePath().normalize();
    return Files.isDirectory(absolute) || target.toString().endsWith("/")
        ? absolute.resolve(word + "_" + LocalDateTime.now().format(NAME) + EXTENSION)
        : absolute;
  }

  /** The name of one of several files. */
  static Path numbered(Path file, int number) {
    String name = file.getFileName().toString();
    String base = name.endsWith(EXTENSION) ? name.substring(0, name.length() - EXTENSION.length()) : name;
    return file.resolveSibling(String.format(Locale.ROOT, "%s_%04d%s", base, number, EXTENSION));
  }

  /** Why a file cannot be begun. */
  Optional<String> obstacle(Path file) {
    Path folder = file.getParent();
    if (!Files.isDirectory(folder)) {
      return Optional.of("the folder " + folder + " is not there; make it, or choose another one");
    }
    if (Files.exists(file)) {
      return Optional.of(file + " is there already, and is not written over; choose another name");
    }
    if (!Files.isWritable(folder)) {
      return Optional.of("nothing can be written to the folder " + folder + ": permission denied");
    }
    try {
      long left = left(folder);
      return left >= LEAST_TO_BEGIN ? Optional.empty()
          : Optional
              .of("only " + size(left) + " are left where " + folder + " lies, which would soon be full; make room,"
                  + " or choose another folder");
    } catch (IOException e) {
      return Optional.of(folder + " cannot be looked at: " + WriteFailure.reason(e));
    }
  }

  /** How much, as people write it. */
  public static String size(long bytes) {
    return bytes >= 10L << 30 ? (bytes >> 30) + " GB"
        : bytes >= 10L << 20 ? (bytes >> 20) + " MB"
            : (bytes >> 10) + " kB";
  }
}
