package org.robotui.ros2.name;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The whole name of a node, topic, service or action in the graph of ROS 2, such as {@code /arm/joint_states}. Each
 * part holds letters, digits and underscores and does not start with a digit. A name of which a part starts with an
 * underscore is hidden: tools do not list it.
 *
 * @param text the name as it is written
 */
public record Ros2Name(String text) implements Comparable<Ros2Name> {

  /** The root namespace. */
  public static final Ros2Name ROOT = new Ros2Name("/");

  /** DDS has room for 255 characters, of which prefixes and endings take some. */
  private static final int MOST_CHARACTERS = 247;
  private static final Pattern PART = Pattern.compile("[A-Za-z_]\\w*");

  /**
   * Checks the name.
   *
   * @throws IllegalArgumentException if the text is no whole name; the message says why
   */
  public Ros2Name {
    fault(Objects.requireNonNull(text, "text")).ifPresent(why -> {
      throw new IllegalArgumentException("'" + text + "' is no name of ROS 2: " + why);
    });
  }

  /**
   * The name with the given text.
   *
   * @param text a whole name
   * @return the name
   * @throws IllegalArgumentException if it is none
   */
  public static Ros2Name of(String text) {
    return new Ros2Name(text);
  }

  /**
   * Reads what a peer calls a name.
   *
   * @param text anything
   * @return empty if it is no whole name
   */
  public static Optional<Ros2Name> parse(String text) {
    return fault(text).isPresent() ? Optional.empty() : Optional.of(new Ros2Name(text));
  }

  private static Optional<String> fault(String text) {
    if (text.equals("/")) {
      return Optional.empty();
    }
    if (!text.startsWith("/")) {
      return Optional.of("it does not start with '/'");
    }
    if (text.length() > MOST_CHARACTERS) {
      return Optional.of("it has more than " + MOST_CHARACTERS + " characters");
    }
    return Arrays.stream(text.substring(1).split("/", -1)).filter(part -> !PART.matcher(part).matches()).findFirst()
        .map(part -> part.isEmpty() ? "a part of it is empty"
            : "its part '" + part + "' must hold letters, digits and '_' and not start with a digit");
  }

  /**
   * The namespace that holds this name.
   *
   * @return {@code /a} for {@code /a/b}, the root for {@code /a} and for the root itself
   */
  public Ros2Name namespace() {
    int slash = text.lastIndexOf('/');
    return slash <= 0 ? ROOT : new Ros2Name(text.substring(0, slash));
  }

  /**
   * The last part.
   *
   * @return {@code b} for {@code /a/b}; empty for the root
   */
  public String base() {
    return text.substring(text.lastIndexOf('/') + 1);
  }

  /**
   * A name below this one.
   *
   * @param relative one or several parts, without a leading slash
   * @return {@code /a/b} for {@code /a} and {@code b}
   * @throws IllegalArgumentException if they are no parts of a name
   */
  public Ros2Name join(String relative) {
    return new Ros2Name((equals(ROOT) ? "" : text) + "/" + relative);
  }

  /**
   * Whether tools leave it out of their lists.
   *
   * @return true if a part starts with an underscore
   */
  public boolean hidden() {
    return text.contains("/_");
  }

  /**
   * Whether a name is this one or lies below it.
   *
   * @param other a name
   * @return true if this name is a namespace of the other, or the same
   */
  public boolean contains(Ros2Name other) {
    return equals(other) || other.text.startsWith(equals(ROOT) ? "/" : text + "/");
  }

  @Override
  public int compareTo(Ros2Name other) {
    return text.compareTo(other.text);
  }

  @Override
  public String toString() {
    return text;
  }
}
