package org.robotui.rfic.recording.internal.export;

import java.nio.file.Path;
import java.util.Optional;

/**
 * What became of a topic.
 *
 * @param topic its name
 * @param file that was written; empty where nothing can be read
 * @param lines how many messages are in it
 * @param unreadable how many could not be read
 * @param note what users should know; empty for nothing
 */
public record ExportedFile(String topic, Optional<Path> file, long lines, long unreadable, String note) {

  /** Whether all of its messages are in the file. */
  public boolean isWhole() {
    return file.isPresent() && unreadable == 0;
  }

  @Override
  public String toString() {
    String what = file.map(path -> path + ": " + lines + (lines == 1 ? " message" : " messages"))
        .orElse("was left out");
    return topic + " " + what + (unreadable == 0 ? "" : ", " + unreadable + " cannot be read")
        + (note.isEmpty() ? "" : " (" + note + ")");
  }
}
