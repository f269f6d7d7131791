package org.robotui.workbench.internal.keys;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.eclipse.jface.bindings.keys.ParseException;

/** Keys as users write and read them, such as {@code Ctrl+Shift+P}; one after another where there are several. */
public final class KeyWords {
  private static final int MOST_LETTERS = 60;
  private static final List<String> MODIFIERS = List.of("CTRL", "ALT", "SHIFT", "COMMAND");

  private KeyWords() {}

  /** The keys of a text; none where it names none. Upper and lower case are the same. */
  public static Optional<KeySequence> read(String text) {
    try {
      return text.length() > MOST_LETTERS ? Optional.empty()
          : Optional.of(KeySequence.getInstance(text.strip().toUpperCase(Locale.ROOT)))
              .filter(keys -> !keys.isEmpty() && keys.isComplete());
    } catch (ParseException e) {
      return Optional.empty();
    }
  }

  /** The same in any language of the desktop, so that a file of keys is read everywhere. */
  public static String text(KeySequence keys) {
    return Arrays.stream(keys.toString().split(" ")).map(KeyWords::stroke).collect(Collectors.joining(" "));
  }

  /** Several keys for the same. */
  public static String text(List<KeySequence> keys) {
    return keys.stream().map(KeyWords::text).collect(Collectors.joining(", "));
  }

  private static String stroke(String formal) {
    return Arrays.stream(formal.split("\\+")).sorted(Comparator.comparingInt(KeyWords::place)).map(KeyWords::capitals)
        .collect(Collectors.joining("+"));
  }

  /** Modifiers in the order in which menus have them, then the key. */
  private static int place(String name) {
    int place = MODIFIERS.indexOf(name);
    return place < 0 ? MODIFIERS.size() : place;
  }

  private static String capitals(String name) {
    return Arrays.stream(name.split("_")).filter(part -> !part.isEmpty())
        .map(part -> part.charAt(0) + part.substring(1).toLowerCase(Locale.ROOT)).collect(Collectors.joining("_"));
  }
}
