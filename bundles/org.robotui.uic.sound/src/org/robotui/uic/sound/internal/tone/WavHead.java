package org.robotui.uic.sound.internal.tone;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import org.robotui.api.config.NamedFile;

/** Tells by their first bytes whether files are sounds; works without Java's sound. */
final class WavHead {
  private static final long MOST_BYTES = 16 << 20;
  private static final int LENGTH = 12;

  private WavHead() {}

  /** What is wrong, behind the name of the file; nothing of its content. */
  static Optional<String> fault(Path file) {
    try {
      byte[] content = NamedFile.bytes(file, MOST_BYTES);
      String head = new String(content, 0, Math.min(LENGTH, content.length), StandardCharsets.ISO_8859_1);
      return head.matches("(?s)RIFF....WAVE") ? Optional.empty() : Optional.of("is none");
    } catch (IOException e) {
      return Optional.of(e.getMessage());
    }
  }
}
