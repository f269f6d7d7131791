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
 * @param state whether it says where the user left the view rather than how the view is to be, such as where its camera
 * was: it is kept for the next start, and neither given to others with a perspective nor compared with theirs
 */
public record Setting(String name, ValueType type, Optional<Object> fallback, boolean required, String help,
    boolean state) {
  /**
   * A setting that says how a view is to be.
   *
   * @param name as written in YAML
   * @param type what it may hold
   * @param fallback its value when it is not written
   * @param required true where it must be written
   * @param help a sentence for users
   */
  public Setting(String name, ValueType type, Optional<Object> fallback, boolean required, String help) {
    this(name, type, fallback, required, help, false);
  }

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

  /**
   * The same, as what says where the user left the view.
   *
   * @return a setting that is a state
   */
  public Setting asState() {
    return new Setting(name, type, fallback, required, help, true);
  }
}
