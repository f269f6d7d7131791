package org.robotui.lcm.type;

import java.util.List;

/**
 * One member of a struct.
 *
 * @param name its name
 * @param type a built-in type, or the full name of another type
 * @param dimensions of an array, outermost first; empty for a single value
 * @param place where it is declared
 */
public record MemberDefinition(String name, String type, List<Dimension> dimensions, Place place) {

  /** Copies the list. */
  public MemberDefinition {
    dimensions = List.copyOf(dimensions);
  }

  /**
   * Whether this is an array.
   *
   * @return true if there are dimensions
   */
  public boolean isArray() {
    return !dimensions.isEmpty();
  }

  /** As it stands in a file. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(type).append(' ').append(name);
    dimensions.forEach(dimension -> text.append('[').append(dimension.text()).append(']'));
    return text.toString();
  }
}
