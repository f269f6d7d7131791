package org.robotui.ui.display;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Settings;

/** Lists in settings. */
public final class DisplayCodec {
  private DisplayCodec() {}

  /**
   * Reads a list; each gets an id of its own.
   *
   * @param settings of the view
   * @param list the name of the setting
   * @return in the order of the list
   */
  public static List<DisplaySpec> read(Settings settings, String list) {
    List<DisplaySpec> specs = new ArrayList<>();
    Set<String> taken = new HashSet<>();
    for (Object group : settings.list(list)) {
      Map<String, Object> fields = Written.fields(group);
      String type = Written.text(fields, DisplayEntry.TYPE).strip();
      String wanted = Written.text(fields, DisplayEntry.ID).strip();
      specs.add(new DisplaySpec(free(wanted.isEmpty() ? type : wanted, taken), type,
          Written.text(fields, DisplayEntry.NAME).strip(),
          Written.texts(fields.getOrDefault(DisplayEntry.SOURCE, List.of())),
          Written.flag(fields, DisplayEntry.SHOWN, true),
          plain(Written.fields(fields.getOrDefault(DisplayEntry.SETTINGS, Map.of())))));
    }
    return List.copyOf(specs);
  }

  /** Without where they are written. */
  private static Map<String, Object> plain(Map<String, Object> settings) {
    Map<String, Object> plain = new LinkedHashMap<>();
    settings.forEach((name, value) -> plain.put(name, value instanceof Placed placed ? placed.value() : value));
    return plain;
  }

  /**
   * Writes a list.
   *
   * @param specs in order
   * @return as a setting holds it
   */
  public static List<Object> write(List<DisplaySpec> specs) {
    return specs.stream().<Object>map(DisplayCodec::write).toList();
  }

  /**
   * An id that nothing has yet, which it takes.
   *
   * @param wanted the id, or how it begins
   * @param taken those that are taken; gets one more
   * @return the id
   */
  public static String free(String wanted, Set<String> taken) {
    String id = wanted;
    for (int i = 2; !taken.add(id); i++) {
      id = wanted + '-' + i;
    }
    return id;
  }

  private static Map<String, Object> write(DisplaySpec spec) {
    Map<String, Object> written = new LinkedHashMap<>();
    written.put(DisplayEntry.TYPE, spec.type());
    written.put(DisplayEntry.ID, spec.id());
    if (!spec.name().isEmpty()) {
      written.put(DisplayEntry.NAME, spec.name());
    }
    if (!spec.sources().isEmpty()) {
      written.put(DisplayEntry.SOURCE, spec.sources());
    }
    written.put(DisplayEntry.SHOWN, spec.shown());
    if (!spec.settings().isEmpty()) {
      written.put(DisplayEntry.SETTINGS, spec.settings());
    }
    return written;
  }
}
