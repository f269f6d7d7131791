package org.robotui.ui.display;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.robotui.api.config.SettingsStore;

/**
 * What the user changes in a list, kept in the settings of the view. With the first change what was shown by itself is
 * written down. Safe for all threads that change one after another.
 */
public class DisplayList {
  /** Where a list is written, and how it grows. */
  public enum Growth {
    /** A new one comes last; what robots offer is shown by itself only while nothing is listed. */
    LAST,
    /**
     * A new one comes first, which lies on top of the others; what robots offer beside what is listed is shown as well.
     */
    FIRST
  }

  private final SettingsStore settings;
  private final String name;
  private final Growth growth;
  private final Supplier<List<DisplaySpec>> now;

  /**
   * A list.
   *
   * @param settings of the view
   * @param name of the setting that holds the list
   * @param growth how it grows
   * @param now what is listed now, also what nobody wrote
   */
  public DisplayList(SettingsStore settings, String name, Growth growth, Supplier<List<DisplaySpec>> now) {
    this.settings = settings;
    this.name = name;
    this.growth = growth;
    this.now = now;
  }

  /**
   * Adds one of a source.
   *
   * @param type its kind
   * @param source its name
   * @return its id
   */
  public String add(String type, String source) {
    String id = add(type);
    change(id, spec -> spec.from(List.of(source)));
    return id;
  }

  /**
   * Adds one.
   *
   * @param type its kind
   * @return its id
   */
  public String add(String type) {
    List<DisplaySpec> specs = new ArrayList<>(now.get());
    Set<String> taken = specs.stream().map(DisplaySpec::id).collect(Collectors.toCollection(HashSet::new));
    String id = DisplayCodec.free(type, taken);
    specs.add(growth == Growth.FIRST ? 0 : specs.size(), DisplaySpec.of(id, type));
    write(specs);
    return id;
  }

  /**
   * Removes one. What is shown by itself would come back, so that from then on only what is listed is shown.
   *
   * @param id of it
   */
  public void remove(String id) {
    List<DisplaySpec> specs = now.get().stream().filter(s -> !s.id().equals(id)).toList();
    if (specs.isEmpty() || growth == Growth.FIRST) {
      settings.set(DisplayEntry.AUTOMATIC, false);
    }
    write(specs);
  }

  /**
   * Moves one among the others; does nothing at the end of the list.
   *
   * @param id of it
   * @param by -1 for up, 1 for down
   */
  public void move(String id, int by) {
    List<DisplaySpec> specs = new ArrayList<>(now.get());
    for (int i = 0; i < specs.size(); i++) {
      if (specs.get(i).id().equals(id) && i + by >= 0 && i + by < specs.size()) {
        Collections.swap(specs, i, i + by);
        write(specs);
        return;
      }
    }
  }

  /**
   * Changes one.
   *
   * @param id of it
   * @param change gives it as it is to be
   */
  public void change(String id, UnaryOperator<DisplaySpec> change) {
    List<DisplaySpec> before = now.get();
    List<DisplaySpec> after = before.stream().map(s -> s.id().equals(id) ? change.apply(s) : s).toList();
    if (!after.equals(before)) {
      write(after);
    }
  }

  /**
   * Sets one setting of one.
   *
   * @param id of it
   * @param setting its name
   * @param value its value
   */
  public void set(String id, String setting, Object value) {
    change(id, spec -> {
      Map<String, Object> values = new LinkedHashMap<>(spec.settings());
      values.put(setting, value);
      return spec.with(values);
    });
  }

  /** Shows what robots offer again, in place of what is listed. */
  public void automatic() {
    settings.set(DisplayEntry.AUTOMATIC, true);
    settings.set(name, List.of());
  }

  private void write(List<DisplaySpec> specs) {
    settings.set(name, DisplayCodec.write(specs));
  }
}
