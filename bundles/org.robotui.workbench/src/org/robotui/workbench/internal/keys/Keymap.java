package org.robotui.workbench.internal.keys;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.eclipse.jface.bindings.keys.KeySequence;

/**
 * Which keys run which commands: the usual ones, and what the user has changed. Changes of commands that are not
 * installed now are kept. Immutable.
 *
 * @param commands all commands
 * @param changes the keys of those commands that do not have their usual ones, by id
 */
public record Keymap(List<KeyedCommand> commands, Map<String, List<KeySequence>> changes) {
  /** Before any command is known. */
  public static final Keymap EMPTY = new Keymap(List.of(), Map.of());

  /** Copies both, and leaves out what changes nothing and what may not be changed. */
  public Keymap {
    commands = List.copyOf(commands);
    Map<String, List<KeySequence>> kept = new LinkedHashMap<>(changes);
    commands.stream().filter(c -> c.fixed() || c.usual().equals(kept.get(c.id()))).map(KeyedCommand::id)
        .forEach(kept::remove);
    changes = kept;
  }

  /** The keys that a command shall have; another one may have them, too. */
  public List<KeySequence> keys(KeyedCommand command) {
    return changes.getOrDefault(command.id(), command.usual());
  }

  /** Whether the user has changed the keys of a command. */
  public boolean isChanged(KeyedCommand command) {
    return changes.containsKey(command.id());
  }

  /** Gives a command keys in place of those that it has. */
  public Keymap with(KeyedCommand command, List<KeySequence> keys) {
    return changed(next -> {
      next.put(command.id(), List.copyOf(keys));
      return next;
    });
  }

  /** Gives a command keys, and takes them from all that have them. */
  public Keymap taking(KeyedCommand command, List<KeySequence> keys) {
    Keymap next = this;
    for (KeySequence each : keys) {
      for (KeyedCommand holder : next.holders(each, command)) {
        next = next.with(holder, next.keys(holder).stream().filter(k -> !clash(k, each)).toList());
      }
    }
    return next.with(command, keys);
  }

  /** Gives a command its usual keys. */
  public Keymap reset(KeyedCommand command) {
    return changed(next -> {
      next.remove(command.id());
      return next;
    });
  }

  /** Gives all commands their usual keys. */
  public Keymap usual() {
    return new Keymap(commands, Map.of());
  }

  /** The same for other commands: some were installed or have gone. */
  public Keymap of(List<KeyedCommand> next) {
    return new Keymap(next, changes);
  }

  /** The commands beside one that have a key, or one that begins as it. */
  public List<KeyedCommand> holders(KeySequence keys, KeyedCommand beside) {
    return commands.stream().filter(c -> !c.id().equals(beside.id()))
        .filter(c -> keys(c).stream().anyMatch(k -> clash(k, keys))).toList();
  }

  /** The command of an id. */
  public Optional<KeyedCommand> command(String id) {
    return commands.stream().filter(c -> c.id().equals(id)).findFirst();
  }

  /**
   * What each key runs. Where several commands have the same key, it runs one that the user has given it to; among
   * those, the first.
   */
  public Map<KeySequence, KeyedCommand> bound() {
    Map<KeySequence, KeyedCommand> bound = new LinkedHashMap<>();
    Stream.of(fixedOnes(), commands.stream().filter(this::isChanged), commands.stream()).flatMap(s -> s)
        .forEach(c -> keys(c).stream().filter(k -> bound.keySet().stream().noneMatch(other -> clash(other, k)))
            .forEach(k -> bound.put(k, c)));
    return bound;
  }

  private Stream<KeyedCommand> fixedOnes() {
    return commands.stream().filter(KeyedCommand::fixed);
  }

  private Keymap changed(UnaryOperator<Map<String, List<KeySequence>>> change) {
    return new Keymap(commands, change.apply(new LinkedHashMap<>(changes)));
  }

  private static boolean clash(KeySequence one, KeySequence other) {
    return one.startsWith(other, true) || other.startsWith(one, true);
  }

  /** The commands that do not have one of their keys, as it runs another one; in the order of all. */
  public List<KeyedCommand> conflicts() {
    Map<KeySequence, KeyedCommand> bound = bound();
    List<KeyedCommand> without = new ArrayList<>(commands);
    without.removeIf(c -> keys(c).stream().allMatch(k -> c.equals(bound.get(k))));
    return without;
  }
}
