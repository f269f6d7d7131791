package org.robotui.api.record;

import java.nio.file.Path;
import java.util.List;

/** What became of a wish to begin, to end or to save a recording. */
public sealed interface RecordingOutcome {
  /**
   * A sentence for users.
   *
   * @return what happened, or why it did not and what would help
   */
  String sentence();

  /**
   * It was done.
   *
   * @param files that were begun or are whole now
   * @param sentence for users
   */
  record Done(List<Path> files, String sentence) implements RecordingOutcome {
    /**
     * Copies the list.
     *
     * @param files that were begun or are whole now
     * @param sentence for users
     */
    public Done {
      files = List.copyOf(files);
    }
  }

  /**
   * It was not done.
   *
   * @param sentence why, and what would help
   */
  record Refused(String sentence) implements RecordingOutcome {}
}
