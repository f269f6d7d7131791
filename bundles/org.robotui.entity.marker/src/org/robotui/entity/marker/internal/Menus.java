package org.robotui.entity.marker.internal;

import java.util.List;
import org.robotui.data.marker.InteractiveMarker.MenuEntry;
import org.robotui.gl.shape.Handle.Choice;

/** Menus of interactive markers as trees. */
final class Menus {
  private static final int DEEPEST = 8;

  private Menus() {}

  static List<Choice> of(List<MenuEntry> entries) {
    return below(entries, 0, 0);
  }

  /** Entries that are each other's parents are left out: nothing leads to them. */
  private static List<Choice> below(List<MenuEntry> entries, int parent, int depth) {
    return depth > DEEPEST ? List.of()
        : entries.stream().filter(e -> e.parent() == parent && e.id() != parent).map(e -> choice(entries, e, depth))
            .toList();
  }

  /** A tick is written into the title, as there is no other way in the messages. */
  private static Choice choice(List<MenuEntry> entries, MenuEntry entry, int depth) {
    String title = entry.title();
    boolean ticked = title.startsWith("[x] ");
    boolean open = title.startsWith("[ ] ");
    String label = ticked || open ? title.substring(4) : title;
    return new Choice(entry.id(), label, ticked, below(entries, entry.id(), depth + 1));
  }
}
