package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Settings;
import org.robotui.uic.scene3d.internal.SceneOptions;

/** Displays in settings. */
public final class DisplayCodec {
  private DisplayCodec() {}

  /** Reads the list of displays; each gets an id of its own. */
  public static List<DisplaySpec> read(Settings settings) {
    List<DisplaySpec> specs = new ArrayList<>();
    Set<String> taken = new HashSet<>();
    for (Object group : settings.list(SceneOptions.DISPLAYS)) {
      Map<String, Object> fields = Written.fields(group);
      String type = Written.text(fields, SceneOptions.TYPE).strip();
      String wanted = Written.text(fields, SceneOptions.ID).strip();
      specs.add(new DisplaySpec(free(wanted.isEmpty() ? type : wanted, taken), type,
          Written.text(fields, SceneOptions.NAME).strip(),
          Written.texts(fields.getOrDefault(SceneOptions.SOURCE, List.of())),
          Written.flag(fields, SceneOptions.SHOWN, true),
          plain(Written.fields(fields.getOrDefault(SceneOptions.SETTINGS, Map.of())))));
    }
    return List.copyOf(specs);
  }

  /** Without where they are written. */
  private static Map<String, Object> plain(Map<String, Object> settings) {
    Map<String, Object> plain = new LinkedHashMap<>();
    settings.forEach((name, value) -> plain.put(name, value instanceof Placed placed ? placed.value() : value));
    return plain;
  }

  /** Writes the list of displays. */
  public static List<Object> write(List<DisplaySpec> specs) {
    return specs.stream().<Object>map(DisplayCodec::write).toList();
  }

  /** An id that nothing has yet, which it takes. */
  static String free(String wanted, Set<String> taken) {
    String id = wanted;
    for (int i = 2; !taken.add(id); i++) {
      id = wanted + '-' + i;
    }
    return id;
  }

  private static Map<String, Object> write(DisplaySpec spec) {
    Map<String, Object> written = new LinkedHashMap<>();
    written.put(SceneOptions.TYPE, spec.type());
    written.put(SceneOptions.ID, spec.id());
    if (!spec.name().isEmpty()) {
      written.put(SceneOptions.NAME, spec.name());
    }
    if (!spec.sources().isEmpty()) {
      written.put(SceneOptions.SOURCE, spec.sources());
    }
    written.put(SceneOptions.SHOWN, spec.shown());
    if (!spec.settings().isEmpty()) {
      written.put(SceneOptions.SETTINGS, spec.settings());
    }
    return written;
  }
}
