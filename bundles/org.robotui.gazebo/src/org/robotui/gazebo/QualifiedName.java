package org.robotui.gazebo;

import java.util.Optional;

/**
 * The name of a topic or a service with the partition that it is in. Nodes of other partitions do not see it.
 *
 * @param partition as users write it, may be empty
 * @param name begins with a slash
 */
public record QualifiedName(String partition, String name) {
  private static final int LONGEST = 65535;
  private static final String AT = "@";
  private static final String SLASH = "/";

  /**
   * Checks both parts.
   *
   * @throws IllegalArgumentException where the protocol has no such names
   */
  public QualifiedName {
    checkPartition(partition);
    check(name);
    if (!name.startsWith(SLASH)) {
      throw new IllegalArgumentException("the name '" + name + "' does not begin with a slash");
    }
  }

  /**
   * Reads what stands in messages.
   *
   * @param text such as {@code @/partition@/name}
   * @return the name, or none where the text is none
   */
  public static Optional<QualifiedName> parse(String text) {
    int end = text.lastIndexOf('@');
    if (!text.startsWith(AT) || end == 0) {
      return Optional.empty();
    }
    String partition = text.substring(1, end);
    try {
      return Optional.of(new QualifiedName(partition.startsWith(SLASH) ? partition.substring(1) : partition,
          text.substring(end + 1)));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /**
   * What stands in messages.
   *
   * @return such as {@code @/partition@/name}
   */
  public String text() {
    return AT + (partition.isEmpty() || partition.startsWith(SLASH) ? "" : SLASH) + partition + AT + name;
  }

  /**
   * Whether a partition may be called so.
   *
   * @param partition may be empty
   * @throws IllegalArgumentException where it may not; says why
   */
  public static void checkPartition(String partition) {
    if (!partition.isEmpty()) {
      check(partition);
    }
  }

  /**
   * Whether a topic or a service may be called so.
   *
   * @param name with or without the slash at its begin
   * @throws IllegalArgumentException where it may not; says why
   */
  public static void check(String name) {
    boolean wrong = name.isEmpty() || name.equals(SLASH) || name.length() > LONGEST || name.contains("//")
        || name.contains(":=") || name.chars().anyMatch(c -> c == '@' || c == '~' || c == ' ' || c < ' ');
    if (wrong) {
      throw new IllegalArgumentException("a name has from 1 to " + LONGEST
          + " characters, but no spaces, '@', '~', ':=' or '//', and is not only a slash");
    }
  }
}
