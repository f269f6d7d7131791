package org.robotui.smartsoft.naming;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The name of a service at a naming service, written as {@code <component><pattern><service><type>...}.
 *
 * @param component that offers it
 * @param pattern how it is used, such as {@code Push}
 * @param service its name within the component
 * @param types the communication objects: one of push and send; request and answer of a query; parameter and event
 */
public record ServiceName(String component, String pattern, String service, List<String> types) {

  private static final int FIXED = 3;
  private static final int MOST = 5;

  /** Copies the list; refuses what cannot be written with an {@link IllegalArgumentException}. */
  public ServiceName {
    types = List.copyOf(types);
    if (Stream.concat(Stream.of(component, pattern, service), types.stream())
        .anyMatch(part -> part.isEmpty() || part.contains("<") || part.contains(">"))) {
      throw new IllegalArgumentException("a part of a service's name is empty, or has brackets");
    }
  }

  /**
   * Reads a name.
   *
   * @param written with brackets
   * @return empty where it is no name of a service
   */
  public static Optional<ServiceName> parse(String written) {
    List<String> parts = new ArrayList<>();
    int at = 0;
    while (at < written.length()) {
      int close = written.indexOf('>', at);
      if (written.charAt(at) != '<' || close <= at + 1 || written.lastIndexOf('<', close) != at
          || parts.size() == MOST) {
        return Optional.empty();
      }
      parts.add(written.substring(at + 1, close));
      at = close + 1;
    }
    return parts.size() <= FIXED ? Optional.empty()
        : Optional.of(new ServiceName(parts.get(0), parts.get(1), parts.get(2), parts.subList(FIXED, parts.size())));
  }

  /**
   * The pattern, where it is one that this library speaks.
   *
   * @return empty for another
   */
  public Optional<SmartPattern> known() {
    return SmartPattern.of(pattern, types.size());
  }

  /**
   * A short form, as people call it.
   *
   * @return component and service, such as {@code base/baseState}
   */
  public String path() {
    return component + "/" + service;
  }

  @Override
  public String toString() {
    return Stream.concat(Stream.of(component, pattern, service), types.stream()).map(part -> "<" + part + ">")
        .collect(Collectors.joining());
  }
}
