package org.robotui.ui.display;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Placed;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;

/** What is wrong with settings of a list by the schemas of their kinds, where it is written in a file. */
public final class DisplayFaults {
  private DisplayFaults() {}

  /**
   * Judges a list. A kind that is not installed is told by the view: it may come while the view runs.
   *
   * @param view the settings of the view
   * @param list the name of the setting
   * @param noun what one is called, for example {@code display}
   * @param kinds those that are there
   * @return what is wrong, where it is written
   */
  public static List<SettingFault> of(Settings view, String list, String noun, List<DisplayKind> kinds) {
    List<SettingFault> faults = new ArrayList<>();
    for (Object group : view.list(list)) {
      Map<String, Object> display = Written.fields(group);
      String type = Written.text(display, DisplayEntry.TYPE);
      Optional<DisplayKind> kind = kinds.stream().filter(k -> k.id().equals(type)).findFirst();
      kind.ifPresent(
          k -> faults.addAll(of(noun, k, Written.fields(display.getOrDefault(DisplayEntry.SETTINGS, Map.of())))));
    }
    return faults;
  }

  private static List<SettingFault> of(String noun, DisplayKind kind, Map<String, Object> settings) {
    List<SettingFault> faults = new ArrayList<>();
    settings.forEach((name, written) -> {
      Placed placed = written instanceof Placed p ? p : Placed.nowhere(written);
      KindSettings.check(kind.schema(), Map.of(name, placed.value())).problems()
          .forEach(problem -> faults.add(placed.fault(noun + " '" + kind.id() + "': " + problem + remedy(kind, name))));
    });
    return faults;
  }

  private static String remedy(DisplayKind kind, String name) {
    List<String> names = kind.schema().settings().stream().map(s -> s.name()).toList();
    if (names.contains(name)) {
      return "";
    }
    return names.isEmpty() ? "; there is nothing to set here" : "; there are " + String.join(", ", names);
  }
}
