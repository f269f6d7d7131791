package org.robotui.message.description;

import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The name of a type as ROS 2 has it, such as {@code std_msgs/msg/String}.
 *
 * @param packageName the package, such as {@code std_msgs}
 * @param kind what it is part of
 * @param name the type's own name, such as {@code String} or {@code SetBool_Request}
 */
public record TypeName(String packageName, Kind kind, String name) {

  private static final Pattern FORM =
      Pattern.compile("([A-Za-z]\\w{0,254})/(msg|srv|action)/([A-Za-z]\\w{0,254})");

  /** What types are part of. */
  public enum Kind {
    /** A message. */
    MSG,
    /** A service, or what it is made of. */
    SRV,
    /** An action, or what it is made of. */
    ACTION;

    /**
     * The kind as it stands in names.
     *
     * @return {@code msg}, {@code srv} or {@code action}
     */
    public String text() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** Checks that nothing is missing. */
  public TypeName {
    Objects.requireNonNull(packageName, "packageName");
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(name, "name");
  }

  /**
   * Reads a name.
   *
   * @param text such as {@code std_msgs/msg/String}
   * @return empty if it has not three parts, or another kind
   */
  public static Optional<TypeName> parse(String text) {
    Matcher parts = FORM.matcher(text);
    return parts.matches()
        ? Optional.of(
            new TypeName(parts.group(1), Kind.valueOf(parts.group(2).toUpperCase(Locale.ROOT)), parts.group(3)))
        : Optional.empty();
  }

  /**
   * The name of a type that is written with two parts or three.
   *
   * @param text such as {@code std_msgs/String} or {@code std_msgs/msg/String}
   * @param kind what it is part of, where the text does not say
   * @return empty if it is no name of a type
   */
  public static Optional<TypeName> parse(String text, Kind kind) {
    int slash = text.indexOf('/');
    return slash >= 0 && text.indexOf('/', slash + 1) < 0
        ? parse(text.substring(0, slash) + "/" + kind.text() + text.substring(slash))
        : parse(text);
  }

  /**
   * The name without the kind, as this library names messages of both generations.
   *
   * @return such as {@code std_msgs/String}
   */
  public String plain() {
    return packageName + "/" + name;
  }

  /**
   * The name of a part of this type.
   *
   * @param part such as {@code Request}
   * @return such as {@code std_srvs/srv/SetBool_Request}
   */
  public TypeName part(String part) {
    return new TypeName(packageName, kind, name + "_" + part);
  }

  /**
   * The type that has this one as a part.
   *
   * @param part such as {@code Request}
   * @return such as {@code std_srvs/srv/SetBool}; empty if this name does not end so
   */
  public Optional<TypeName> whole(String part) {
    String end = "_" + part;
    return name.endsWith(end) && name.length() > end.length()
        ? Optional.of(new TypeName(packageName, kind, name.substring(0, name.length() - end.length())))
        : Optional.empty();
  }

  /** The action that this type is part of, or is. */
  TypeName action() {
    TypeName service = whole("Request").or(() -> whole("Response")).or(() -> whole("Event")).orElse(this);
    return Stream.concat(ActionParts.SERVICES.stream(), ActionParts.MESSAGES.stream())
        .flatMap(part -> service.whole(part).stream()).findFirst().orElse(service);
  }

  /** The whole name, such as {@code std_msgs/msg/String}. */
  @Override
  public String toString() {
    return packageName + "/" + kind.text() + "/" + name;
  }
}
