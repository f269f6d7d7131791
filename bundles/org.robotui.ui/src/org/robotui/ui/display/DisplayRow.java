package org.robotui.ui.display;

import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.ui.Health;

/**
 * One of a list, as users see it.
 *
 * @param spec as written
 * @param name for users
 * @param health its dot
 * @param words why nothing is seen, or how much is
 * @param bytes memory of what it shows
 * @param dropped values that it could not show
 * @param settings of its kind, checked; none while the kind is not there
 * @param choices names of the sources that would fit
 */
public record DisplayRow(DisplaySpec spec, String name, Health health, String words, long bytes, long dropped,
    Optional<Settings> settings, List<String> choices) {
  /**
   * Copies the list.
   *
   * @param spec as written
   * @param name for users
   * @param health its dot
   * @param words how it is
   * @param bytes memory
   * @param dropped values
   * @param settings checked
   * @param choices names of sources
   */
  public DisplayRow {
    choices = List.copyOf(choices);
  }
}
