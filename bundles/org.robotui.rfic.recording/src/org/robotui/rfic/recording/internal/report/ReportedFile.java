package org.robotui.rfic.recording.internal.report;

import java.util.List;

/**
 * The recording that a report is about.
 *
 * @param name of the file, for users
 * @param damages what could not be read, as sentences
 */
public record ReportedFile(String name, List<String> damages) {
  public ReportedFile {
    damages = List.copyOf(damages);
  }
}
