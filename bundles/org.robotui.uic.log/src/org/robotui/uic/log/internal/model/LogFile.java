package org.robotui.uic.log.internal.model;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.robotui.api.config.WriteFailure;

/** Writes the list to a text file. May block. */
public final class LogFile {
  private LogFile() {}

  /** Writes the lines in UTF-8, and says what became of it. */
  public static String write(List<LogLine> lines, Wording wording, Path file) {
    try (BufferedWriter out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
      for (LogLine line : lines) {
        out.write(wording.text(line));
        out.newLine();
      }
    } catch (IOException e) {
      return "cannot write " + file + ": " + WriteFailure.reason(e);
    }
    return "saved " + lines.size() + " entries to " + file;
  }
}
