package org.robotui.workbench.internal.model;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.robotui.workbench.internal.UserState;

/**
 * The configurations and recordings that were opened last, kept from one run to the next. Display thread only.
 *
 * @param state keeps them
 */
public record RecentFiles(UserState state) {
  private static final String KEY = "recent";
  private static final int MOST = 8;

  /** One was opened. */
  public void add(Path file) {
    List<String> all = new ArrayList<>(names());
    String name = file.toAbsolutePath().normalize().toString();
    all.remove(name);
    all.addFirst(name);
    state.put(KEY, String.join("\n", all.subList(0, Math.min(MOST, all.size()))));
  }

  /** Those that are still there, the last one first. */
  public List<Path> list() {
    return names().stream().map(Path::of).filter(Files::isReadable).toList();
  }

  private List<String> names() {
    return state.get(KEY).filter(n -> !n.isEmpty()).map(n -> List.of(n.split("\n"))).orElse(List.of());
  }
}
