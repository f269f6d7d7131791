package org.robotui.workbench.internal.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.robotui.ui.Health;
import org.robotui.ui.ViewKey;
import org.robotui.workbench.internal.keys.KeyRules;
import org.robotui.workbench.internal.keys.KeyWords;
import org.robotui.workbench.internal.keys.KeyedCommand;
import org.robotui.workbench.internal.keys.Keymap;

/**
 * A command in the list of all keys.
 *
 * @param command the command
 * @param keys its keys as users read them
 * @param health whether its keys run it
 * @param note a few words on conflicts and changes, may be empty
 */
public record KeyRow(KeyedCommand command, String keys, Health health, String note) {

  /**
   * All commands that have some words in their name, group, keys or help.
   *
   * @param map which keys run which commands
   * @param views the keys of the views that are open, by the title of the view
   * @param words what to search; empty for all
   */
  public static List<KeyRow> of(Keymap map, Map<String, List<ViewKey>> views, String words) {
    Map<KeySequence, KeyedCommand> bound = map.bound();
    List<String> wanted = List.of(words.strip().toLowerCase(Locale.ROOT).split(" +"));
    return map.commands().stream().map(command -> of(command, map, bound, views))
        .filter(row -> wanted.stream().allMatch(row.text().toLowerCase(Locale.ROOT)::contains)).toList();
  }

  private static KeyRow of(KeyedCommand command, Keymap map, Map<KeySequence, KeyedCommand> bound,
      Map<String, List<ViewKey>> views) {
    List<KeySequence> keys = map.keys(command);
    List<String> notes = new ArrayList<>();
    keys.stream().filter(k -> !command.equals(bound.get(k))).forEach(k -> notes.add(conflict(k, command, map)));
    boolean conflict = !notes.isEmpty();
    keys.forEach(k -> notes.addAll(ofViews(k, views)));
    Health health = conflict ? Health.BAD : notes.isEmpty() ? Health.NONE : Health.WARNING;
    if (command.fixed()) {
      notes.add("always, cannot be changed");
    } else if (map.isChanged(command)) {
      notes.add("changed" + (command.usual().isEmpty() ? "" : ", usually " + KeyWords.text(command.usual())));
    }
    return new KeyRow(command, KeyWords.text(keys), health, String.join("; ", notes));
  }

  private static String conflict(KeySequence key, KeyedCommand command, Keymap map) {
    String others = map.holders(key, command).stream().map(c -> "'" + c.name() + "'").collect(Collectors.joining(", "));
    return KeyWords.text(key) + " runs " + (others.isEmpty() ? "another key of this command" : others);
  }

  /** A command takes the key before the view that has the focus sees it. */
  private static Stream<String> keysOf(ViewKey key) {
    return Arrays.stream(key.keys().split("[,\u2026]")).map(String::strip);
  }

  private static List<String> ofViews(KeySequence key, Map<String, List<ViewKey>> views) {
    return views.entrySet().stream().flatMap(view -> view.getValue().stream()
        .filter(own -> keysOf(own).map(KeyWords::read).flatMap(Optional::stream).anyMatch(key::equals))
        .map(own -> "takes " + KeyWords.text(key) + " from the view " + view.getKey() + " (" + own.does() + ")"))
        .toList();
  }

  /** Why a key cannot be given to this command, a sentence. */
  public Optional<String> refusal(KeySequence key) {
    return KeyRules.fixed(command).or(() -> KeyRules.refusal(key));
  }

  private String text() {
    return command.name() + " " + command.group() + " " + keys + " " + command.help() + " " + note;
  }
}
