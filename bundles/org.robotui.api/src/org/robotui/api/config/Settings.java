package org.robotui.api.config;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Checked values: every setting of the schema has a value of its type, or is absent where that is allowed. Asking for a
 * name that the schema lacks, or with the wrong type, is a programming error and throws
 * {@link IllegalArgumentException}.
 *
 * @param schema what may be there
 * @param values Boolean, Long, Double, String, List, Map or nested Settings by name, fallbacks included
 */
public record Settings(Schema schema, Map<String, Object> values) {
  /**
   * Copies the values.
   *
   * @param schema what may be there
   * @param values by name
   */
  public Settings {
    values = Map.copyOf(values);
  }

  /**
   * Tells whether there is a value.
   *
   * @param name the setting
   * @return true where it was written or has a fallback
   */
  public boolean has(String name) {
    known(name);
    return values.containsKey(name);
  }

  /**
   * A text or a word.
   *
   * @param name the setting
   * @return its value
   */
  public String text(String name) {
    return get(name, String.class);
  }

  /**
   * A truth value.
   *
   * @param name the setting
   * @return its value
   */
  public boolean flag(String name) {
    return get(name, Boolean.class);
  }

  /**
   * A number.
   *
   * @param name the setting
   * @return its value
   */
  public double number(String name) {
    return get(name, Number.class).doubleValue();
  }

  /**
   * A whole number.
   *
   * @param name the setting
   * @return its value
   */
  public long integer(String name) {
    return get(name, Long.class);
  }

  /**
   * A value together with where it is written, of a setting whose type is {@link ValueType.WithPlace}.
   *
   * @param name the setting
   * @return its value and place
   */
  public Placed placed(String name) {
    return get(name, Placed.class);
  }

  /**
   * A list.
   *
   * @param name the setting
   * @return its elements
   */
  public List<?> list(String name) {
    return get(name, List.class);
  }

  /**
   * Values by name.
   *
   * @param name the setting
   * @return the map
   */
  public Map<?, ?> map(String name) {
    return get(name, Map.class);
  }

  /**
   * A group.
   *
   * @param name the setting
   * @return the settings in it
   */
  public Settings section(String name) {
    return get(name, Settings.class);
  }

  private <T> T get(String name, Class<T> type) {
    known(name);
    Object value = Optional.ofNullable(values.get(name))
        .orElseThrow(() -> new IllegalArgumentException("the setting '" + name + "' has no value; ask has() first"));
    return type.cast(value);
  }

  private void known(String name) {
    if (schema.find(name).isEmpty()) {
      throw new IllegalArgumentException("no setting '" + name + "' in the schema");
    }
  }
}
