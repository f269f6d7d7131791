package org.robotui.workbench.internal.keys;

import java.util.List;
import org.eclipse.jface.bindings.keys.KeySequence;

/**
 * A command that keys can run.
 *
 * @param id short and unique, as it stands in the file of the user's keys: for example {@code layout.undo}
 * @param name what users read
 * @param group where it belongs: a menu or a category
 * @param help what it does, a sentence; may be empty
 * @param usual the keys that it has where the user has changed nothing
 * @param fixed whether its keys stay as they are: those that stop robots
 */
public record KeyedCommand(String id, String name, String group, String help, List<KeySequence> usual, boolean fixed) {
  /** Copies the list. */
  public KeyedCommand {
    usual = List.copyOf(usual);
  }
}
