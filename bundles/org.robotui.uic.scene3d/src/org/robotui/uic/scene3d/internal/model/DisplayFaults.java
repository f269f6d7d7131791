package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Placed;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.gl.display.DisplayType;
import org.robotui.uic.scene3d.internal.SceneOptions;

/** What is wrong with settings of displays by the schemas of their kinds, where it is written in a file. */
public final class DisplayFaults {
  private DisplayFaults() {}

  /** A kind that is not installed is told by the scene: it may come while the scene runs. */
  public static List<SettingFault> of(Settings scene, List<DisplayType> kinds) {
    List<SettingFault> faults = new ArrayList<>();
    for (Object group : scene.list(SceneOptions.DISPLAYS)) {
      Map<String, Object> display = Written.fields(group);
      String type = Written.text(display, SceneOptions.TYPE);
      Optional<DisplayType> kind = kinds.stream().filter(k -> k.id().equals(type)).findFirst();
      kind.ifPresent(k -> faults.addAll(of(k, Written.fields(display.getOrDefault(SceneOptions.SETTINGS, Map.of())))));
    }
    return faults;
  }

  private static List<SettingFault> of(DisplayType kind, Map<String, Object> settings) {
    List<SettingFault> faults = new ArrayList<>();
    settings.forEach((name, written) -> {
      Placed placed = written instanceof Placed p ? p : Placed.nowhere(written);
      KindSettings.check(kind.schema(), Map.of(name, placed.value())).problems()
          .forEach(problem -> faults.add(placed.fault("display '" + kind.id() + "': " + problem + remedy(kind, name))));
    });
    return faults;
  }

  private static String remedy(DisplayType kind, String name) {
    List<String> names = kind.schema().settings().stream().map(s -> s.name()).toList();
    if (names.contains(name)) {
      return "";
    }
    return names.isEmpty() ? "; there is nothing to set here" : "; there are " + String.join(", ", names);
  }
}
