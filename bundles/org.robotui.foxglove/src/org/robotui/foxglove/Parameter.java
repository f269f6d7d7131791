package org.robotui.foxglove;

/**
 * A named setting.
 *
 * @param name its name
 * @param value a tree of plain values, as of JSON
 * @param type what the value does not tell, such as {@code float64} or {@code byte_array}; empty where it tells all
 */
public record Parameter(String name, Object value, String type) {
  private static final String REAL = "float64";

  /**
   * A setting of the type that its value has. A number with a fraction stays one, also where the fraction is zero.
   *
   * @param name its name
   * @param value a tree of plain values
   * @return the parameter
   */
  public static Parameter of(String name, Object value) {
    return new Parameter(name, value, value instanceof Double ? REAL : "");
  }
}
