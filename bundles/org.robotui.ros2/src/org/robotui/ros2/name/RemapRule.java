package org.robotui.ros2.name;

import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One rule by which a user gives a name another one, such as {@code camera:image:=/front/image}.
 *
 * @param node the base name of the node that it is for; empty for every one
 * @param kind what it is for
 * @param from the name in the program, as written
 * @param to the name instead, as written
 */
public record RemapRule(Optional<String> node, Kind kind, String from, String to) {

  private static final Pattern FORM =
      Pattern.compile("(?:([A-Za-z_]\\w*):(?!//))?(rostopic://|rosservice://)?([^:=]+):=(\\S+)");

  /** What a rule is for. */
  public enum Kind {
    /** Topics and services. */
    ALL,
    /** Topics alone. */
    TOPIC,
    /** Services alone. */
    SERVICE,
    /** The namespace of nodes. */
    NAMESPACE,
    /** The base name of nodes. */
    NODE
  }

  /** Checks that nothing is missing. */
  public RemapRule {
    Objects.requireNonNull(node, "node");
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(from, "from");
    Objects.requireNonNull(to, "to");
  }

  /**
   * Reads a rule.
   *
   * @param text as it stands behind {@code -r} on a command line
   * @return the rule
   * @throws IllegalArgumentException if it is none; the message says what to write
   */
  public static RemapRule parse(String text) {
    Matcher parts = FORM.matcher(text.strip());
    if (!parts.matches()) {
      throw new IllegalArgumentException("'" + text + "' is no remapping; write for example scan:=/front/scan");
    }
    Optional<String> node = Optional.ofNullable(parts.group(1));
    return new RemapRule(node, kind(parts.group(2), parts.group(3)), parts.group(3), parts.group(4));
  }

  private static Kind kind(String scheme, String from) {
    return switch (from) {
      case "__ns" -> Kind.NAMESPACE;
      case "__node", "__name" -> Kind.NODE;
      default -> scheme == null ? Kind.ALL : scheme.startsWith("rostopic") ? Kind.TOPIC : Kind.SERVICE;
    };
  }

  boolean isFor(String nodeName, Kind asked) {
    boolean names = asked == Kind.TOPIC || asked == Kind.SERVICE;
    return (kind == asked || kind == Kind.ALL && names) && node.filter(only -> !only.equals(nodeName)).isEmpty();
  }
}
