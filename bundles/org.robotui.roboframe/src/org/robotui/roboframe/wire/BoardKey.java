package org.robotui.roboframe.wire;

import java.util.List;

/**
 * One key of an application: what it carries, and who uses it.
 *
 * @param name of the key
 * @param type the name of its type, such as {@code roboframe/Scan}
 * @param sum what two definitions have in common that mean the same, as MD5 of ROS
 * @param definition the text of the type, with all types within it
 * @param writers modules that write it
 * @param readers modules that read it; where there are any, values of others are wanted
 */
public record BoardKey(String name, String type, String sum, String definition, List<String> writers,
    List<String> readers) {

  /** Takes copies. */
  public BoardKey {
    writers = List.copyOf(writers);
    readers = List.copyOf(readers);
  }

  /**
   * Whether it carries the same.
   *
   * @param other another key
   * @return true where name, type and sum are equal
   */
  public boolean carriesWhat(BoardKey other) {
    return name.equals(other.name) && type.equals(other.type) && sum.equals(other.sum);
  }
}
