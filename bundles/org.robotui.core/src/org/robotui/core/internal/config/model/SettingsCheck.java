package org.robotui.core.internal.config.model;

import java.util.Map;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;

/** Checks values against a schema. Safe for all threads. */
public interface SettingsCheck {
  /**
   * Checks written values.
   *
   * @param schema what may be there
   * @param raw what was written
   * @return settings with fallbacks, or problems with their places
   */
  CheckedSettings check(Schema schema, RawSection raw);

  /**
   * Checks one value that was not written in a file: Boolean, Number, String, List or Map.
   *
   * @param setting what it is for
   * @param value the value
   * @return the value as settings hold it, or what was expected
   */
  CheckedValue value(Setting setting, Object value);

  /**
   * Nothing written, for views that a RUIC's type brings along and the file does not mention.
   *
   * @return an empty section
   */
  RawSection nothing();

  /**
   * What a user has chosen, as if it was written.
   *
   * @param values Boolean, Number, String, List or Map by name
   * @return a section without a place in a file
   */
  RawSection written(Map<String, Object> values);

  /**
   * What is written, as values, to be compared and shown.
   *
   * @param raw what was written
   * @return by name, in the order of writing: Boolean and numbers where they are written as such, else String, List and
   * Map
   */
  Map<String, Object> values(RawSection raw);
}
