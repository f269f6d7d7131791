package org.robotui.uic.log.internal.model;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;

/** Writes the list to a text file. May block. */
public final class LogFile {
  private LogFile() {}

  /** Writes the lines in UTF-8, and says what became of it. */
  public static String write(List<LogLine> lines, Wording wording, Path file) {
    try {
      AtomicFile.write(file, lines.stream().map(line -> wording.text(line) + "\n").collect(Collectors.joining()));
    } catch (IOException e) {
      return "cannot write " + file + ": " + WriteFailure.reason(e);
    }
    return "saved " + lines.size() + " entries to " + file;
  }
}
