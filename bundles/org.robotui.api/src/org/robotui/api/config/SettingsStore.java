package org.robotui.api.config;

/** The settings of one view, which the user may change while it runs. Safe for all threads. */
public interface SettingsStore {
  /**
   * The settings now in force.
   *
   * @return written values, changed by what the user chose
   */
  Settings current();

  /**
   * Changes one setting. It is checked, in force at once, and kept across restarts by core without blocking the caller.
   *
   * @param name the setting
   * @param value Boolean, Long, Double, String, List or Map fitting its type
   * @throws IllegalArgumentException where the value does not fit
   */
  void set(String name, Object value);
}
