package org.robotui.core.internal.facts;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Files as they may be given away. */
public final class MaskedFiles {
  private static final Logger LOG = LoggerFactory.getLogger(MaskedFiles.class);

  private MaskedFiles() {}

  /**
   * Reads files.
   *
   * @param files which
   * @return their texts without secrets; what cannot be read, or is longer than such a file may be, is left out
   */
  public static Map<Path, String> texts(Collection<Path> files) {
    Map<Path, String> texts = new LinkedHashMap<>();
    for (Path file : files) {
      try {
        if (Files.size(file) <= FactsZip.MOST_OF_ONE) {
          texts.put(file, SecretMask.masked(new String(Files.readAllBytes(file), StandardCharsets.UTF_8)));
        }
      } catch (IOException e) {
        LOG.info("{} is left out, as it cannot be read: {}", file, e.getMessage());
      }
    }
    return texts;
  }
}
