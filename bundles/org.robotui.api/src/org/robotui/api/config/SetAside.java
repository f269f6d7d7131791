package org.robotui.api.config;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;

/**
 * Keeps files that we have written ourselves and cannot understand any more, as a hand or a full disk has damaged them,
 * so that nothing in them is lost when they are written anew. Any thread; blocks.
 */
public final class SetAside {
  private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss");

  private SetAside() {}

  /**
   * Copies a file beside itself, with {@code .damaged-} and the time behind its name.
   *
   * @param file the damaged file, which stays
   * @return a sentence for users on where the copy is, or why there is none
   */
  public static String copy(Path file) {
    Path aside = file.resolveSibling(file.getFileName() + ".damaged-" + TIME.format(LocalDateTime.now()));
    try {
      Files.copy(file, aside, StandardCopyOption.REPLACE_EXISTING);
      return "The file is kept as " + aside + ".";
    } catch (IOException e) {
      return file + " could not be copied: " + e;
    }
  }
}
