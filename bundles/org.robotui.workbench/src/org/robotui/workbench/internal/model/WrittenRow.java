package org.robotui.workbench.internal.model;

import java.util.List;
import java.util.Locale;
import org.robotui.api.host.SettingsGroup;

/**
 * Settings of a configuration file in a list of all.
 *
 * @param group the settings
 * @param what they are of, indented below the robot UI
 * @param kind a word on that
 */
public record WrittenRow(SettingsGroup group, String what, String kind) {
  private static final String BELOW = "    ";

  /**
   * All that has some words in it.
   *
   * @param groups in the order of the files
   * @param words what to search; empty for all
   */
  public static List<WrittenRow> of(List<SettingsGroup> groups, String words) {
    List<String> wanted = List.of(words.strip().toLowerCase(Locale.ROOT).split(" +"));
    return groups.stream().filter(g -> !g.schema().settings().isEmpty()).map(WrittenRow::of)
        .filter(row -> wanted.stream().allMatch(row.text()::contains)).toList();
  }

  private static WrittenRow of(SettingsGroup group) {
    return switch (group.part()) {
      case RUIC -> new WrittenRow(group, group.ruic(), group.type());
      case INTERFACE -> new WrittenRow(group, BELOW + group.id(), "interface, " + group.type());
      case VIEW -> new WrittenRow(group, BELOW + group.title(), "view, " + group.type());
      case CONNECTIONS -> new WrittenRow(group, BELOW + group.title(), "which port goes where");
      case SAFETY -> new WrittenRow(group, BELOW + "Safety of " + group.id(), "limits, stop, lease");
      case BRIDGES -> new WrittenRow(group, "Bridges", "of " + group.file().getFileName());
    };
  }

  /** What identifies it. */
  public Object key() {
    return List.of(group.file(), group.path());
  }

  /** Whose settings they are, and where they stand. */
  public String heading() {
    String own = what.strip();
    return (own.equals(group.ruic()) || group.ruic().isEmpty() ? own : group.ruic() + "  \u00b7  " + own) + "  \u00b7  "
        + place();
  }

  /** File and line, the file by its name alone. */
  public String place() {
    return group.file().getFileName() + ":" + group.line();
  }

  /** When a change of it holds, as a sentence. */
  public String holds() {
    return switch (group.part()) {
      case CONNECTIONS, SAFETY, BRIDGES -> "It takes effect at once.";
      case INTERFACE -> "The window of the robot asks before the interface is exchanged.";
      case RUIC, VIEW -> "Robot > Restart Robot UI takes it up.";
    };
  }

  /** The names of settings and their help are searched as well. */
  private String text() {
    StringBuilder all = new StringBuilder(group.ruic()).append(' ').append(what).append(' ').append(kind);
    group.schema().settings().forEach(s -> all.append(' ').append(s.name()).append(' ').append(s.help()));
    return all.toString().toLowerCase(Locale.ROOT);
  }
}
