package org.robotui.api.host;

import java.nio.file.Path;
import java.util.List;

/** What came of writing settings into a configuration file. */
public sealed interface SettingsOutcome {
  /**
   * They are in the file.
   *
   * @param file which
   * @param changed the names of those that were written or taken out; none where all were as wanted
   */
  record Done(Path file, List<String> changed) implements SettingsOutcome {
    /**
     * Copies the list.
     *
     * @param file which
     * @param changed names
     */
    public Done {
      changed = List.copyOf(changed);
    }
  }

  /**
   * Nothing was written.
   *
   * @param reason a sentence for users: the place, why, and what would help
   */
  record Refused(String reason) implements SettingsOutcome {}
}
