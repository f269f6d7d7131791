package org.robotui.api.host;

import java.nio.file.Path;
import java.util.List;

/** What came of opening a file. */
public sealed interface FileOutcome {
  /**
   * The file.
   *
   * @return as it was named
   */
  Path file();

  /**
   * It is shown, by a configuration that was written for it now or before.
   *
   * @param file as it was named
   * @param configuration where the configuration is kept; as any other it may be edited
   * @param ruics the names of its RUICs
   * @param problems what is wrong with the configuration, which somebody may have edited
   */
  record Opened(Path file, Path configuration, List<String> ruics, List<Problem> problems) implements FileOutcome {
    /**
     * Copies the lists.
     *
     * @param file as it was named
     * @param configuration where the configuration is kept
     * @param ruics names
     * @param problems of the configuration
     */
    public Opened {
      ruics = List.copyOf(ruics);
      problems = List.copyOf(problems);
    }
  }

  /**
   * It is not shown.
   *
   * @param file as it was named
   * @param reason a sentence for users: why, and what would help
   */
  record NotOpened(Path file, String reason) implements FileOutcome {}
}
