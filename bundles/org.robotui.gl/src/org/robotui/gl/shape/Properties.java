package org.robotui.gl.shape;

import java.util.List;

/**
 * What is known of a selected thing.
 *
 * @param title what it is
 * @param entries names and values in the order in which they are shown, values with their units
 */
public record Properties(String title, List<Entry> entries) {
  /**
   * One property.
   *
   * @param name what
   * @param value how much, with its unit
   */
  public record Entry(String name, String value) {}

  /**
   * Copies the list.
   *
   * @param title what it is
   * @param entries names and values
   */
  public Properties {
    entries = List.copyOf(entries);
  }

  /**
   * Some properties.
   *
   * @param title what it is
   * @param entries names and values
   * @return the properties
   */
  public static Properties of(String title, Entry... entries) {
    return new Properties(title, List.of(entries));
  }
}
