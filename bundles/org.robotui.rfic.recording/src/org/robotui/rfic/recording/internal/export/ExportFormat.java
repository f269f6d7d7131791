package org.robotui.rfic.recording.internal.export;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** How messages are written. */
public enum ExportFormat {
  /** A table: a column for each number or text. */
  CSV,
  /** An object of JSON in each line. */
  JSONL;

  /**
   * By the word for it.
   *
   * @param word as on the command line
   * @return none where there is no such format
   */
  public static Optional<ExportFormat> of(String word) {
    return Arrays.stream(values()).filter(each -> each.extension().equals(word)).findFirst();
  }

  /** What names of files end with, without the dot. */
  String extension() {
    return name().toLowerCase(Locale.ROOT);
  }

  MessageLines lines() {
    return this == CSV ? new CsvLines() : new JsonLines();
  }
}
