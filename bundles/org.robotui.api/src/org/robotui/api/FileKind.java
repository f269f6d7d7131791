package org.robotui.api;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Files that a robot interface opens without that a user writes a configuration.
 *
 * @param label what they are, for users, in the plural, for example {@code Recordings}
 * @param extensions what their names end with, without the dot before it, in lower case, at least one
 * @param setting the setting of the type that takes the path of such a file, as a text
 */
public record FileKind(String label, List<String> extensions, String setting) {
  /**
   * Copies and checks.
   *
   * @param label what they are
   * @param extensions what their names end with
   * @param setting takes the path
   * @throws IllegalArgumentException where there is no extension, or one with a dot at its start or capital letters
   */
  public FileKind {
    extensions = List.copyOf(extensions);
    if (extensions.isEmpty()) {
      throw new IllegalArgumentException(label + ": files need an extension");
    }
    extensions.stream().filter(e -> e.isEmpty() || e.startsWith(".") || !e.equals(e.toLowerCase(Locale.ROOT)))
        .findFirst().ifPresent(e -> {
          throw new IllegalArgumentException(label + ": '" + e + "' is no extension in lower case without a dot");
        });
  }

  /**
   * By which of its extensions a name is one of these; whether letters are capital does not matter.
   *
   * @param name of a file
   * @return the longest extension that fits, or none
   */
  public Optional<String> extension(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return extensions.stream().filter(e -> lower.endsWith("." + e) && lower.length() > e.length() + 1)
        .max((a, b) -> Integer.compare(a.length(), b.length()));
  }
}
