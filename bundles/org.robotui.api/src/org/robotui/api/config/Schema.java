package org.robotui.api.config;

import java.util.List;
import java.util.Optional;

/**
 * What a component can be configured with. Core checks the written values against it before the component sees them.
 *
 * @param settings all settings
 */
public record Schema(List<Setting> settings) {
  /** Nothing to configure. */
  public static final Schema EMPTY = new Schema(List.of());

  /**
   * Copies the list.
   *
   * @param settings all settings
   */
  public Schema {
    settings = List.copyOf(settings);
  }

  /**
   * A schema of some settings.
   *
   * @param settings the settings
   * @return the schema
   */
  public static Schema of(Setting... settings) {
    return new Schema(List.of(settings));
  }

  /**
   * Finds a setting.
   *
   * @param name as written in YAML
   * @return the setting, or none
   */
  public Optional<Setting> find(String name) {
    return settings.stream().filter(s -> s.name().equals(name)).findFirst();
  }
}
