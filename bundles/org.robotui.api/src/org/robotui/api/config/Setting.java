package org.robotui.api.config;

import java.util.Optional;

/**
 * One setting.
 *
 * @param name as written in YAML
 * @param type what it may hold
 * @param fallback its value when it is not written; where this is empty and the setting not required, it may be absent
 * @param required true where it must be written
 * @param help a sentence for users
 */
public record Setting(String name, ValueType type, Optional<Object> fallback, boolean required, String help) {
  /**
   * A setting that must be written.
   *
   * @param name as written in YAML
   * @param type what it may hold
   * @param help a sentence for users
   * @return the setting
   */
  public static Setting required(String name, ValueType type, String help) {
    return new Setting(name, type, Optional.empty(), true, help);
  }

  /**
   * A setting that may be absent.
   *
   * @param name as written in YAML
   * @param type what it may hold
   * @param help a sentence for users
   * @return the setting
   */
  public static Setting optional(String name, ValueType type, String help) {
    return new Setting(name, type, Optional.empty(), false, help);
  }

  /**
   * A setting with a value when it is not written.
   *
   * @param name as written in YAML
   * @param type what it may hold
   * @param fallback Boolean, Long, Double, String, List or Map, fitting the type
   * @param help a sentence for users
   * @return the setting
   */
  public static Setting of(String name, ValueType type, Object fallback, String help) {
    return new Setting(name, type, Optional.of(fallback), false, help);
  }
}
