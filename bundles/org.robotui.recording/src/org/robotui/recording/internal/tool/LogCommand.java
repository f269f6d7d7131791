package org.robotui.recording.internal.tool;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.recording.ChunkCompression;

/** What was asked for on the command line. */
record LogCommand(Verb verb, Path file, Optional<Path> to, boolean json, ChunkCompression compression) {

  enum Verb {
    INFO, CHECK, REPAIR, CONVERT;

    boolean writes() {
      return this == REPAIR || this == CONVERT;
    }
  }

  /** Empty where that cannot be understood. */
  static Optional<LogCommand> of(List<String> arguments) {
    List<String> words = new ArrayList<>(arguments);
    Optional<Verb> verb = words.isEmpty() ? Optional.empty() : verb(words.remove(0));
    boolean json = words.remove("--json");
    int option = words.indexOf("--compression");
    Optional<ChunkCompression> compression = Optional.of(ChunkCompression.ZSTD);
    if (option >= 0 && option + 1 < words.size()) {
      compression = LogTool.compression(words.remove(option + 1));
      words.remove(option);
    }
    if (verb.isEmpty() || compression.isEmpty() || words.stream().anyMatch(word -> word.startsWith("--"))
        || words.size() != (verb.get().writes() ? 2 : 1) || json && verb.get().writes()
        || option >= 0 && !verb.get().writes()) {
      return Optional.empty();
    }
    return Optional
        .of(new LogCommand(verb.get(), Path.of(words.get(0)), words.stream().skip(1).map(Path::of).findFirst(),
            json, compression.get()));
  }

  private static Optional<Verb> verb(String word) {
    for (Verb verb : Verb.values()) {
      if (verb.name().toLowerCase(Locale.ROOT).equals(word)) {
        return Optional.of(verb);
      }
    }
    return Optional.empty();
  }
}
