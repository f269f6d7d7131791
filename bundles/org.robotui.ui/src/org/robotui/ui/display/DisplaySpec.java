package org.robotui.ui.display;

import java.util.List;
import java.util.Map;

/**
 * One of a list, as it is written in the settings.
 *
 * @param id tells them apart while names and order change
 * @param type its kind
 * @param name in the list; empty for that of its kind
 * @param sources where its data come from; empty to choose by itself
 * @param shown whether it is to be seen
 * @param settings of its kind, as written
 */
public record DisplaySpec(String id, String type, String name, List<String> sources, boolean shown,
    Map<String, Object> settings) {
  /**
   * Copies the collections.
   *
   * @param id of it
   * @param type its kind
   * @param name in the list
   * @param sources of its data
   * @param shown whether it is to be seen
   * @param settings as written
   */
  public DisplaySpec {
    sources = List.copyOf(sources);
    settings = Map.copyOf(settings);
  }

  /**
   * One as it comes.
   *
   * @param id tells it apart
   * @param type its kind
   * @return shown, with the settings that its kind begins with
   */
  public static DisplaySpec of(String id, String type) {
    return new DisplaySpec(id, type, "", List.of(), true, Map.of());
  }

  /**
   * The same, switched.
   *
   * @param on whether it is to be seen
   * @return the other
   */
  public DisplaySpec show(boolean on) {
    return new DisplaySpec(id, type, name, sources, on, settings);
  }

  /**
   * The same under another name.
   *
   * @param other the name; empty for that of its kind
   * @return the other
   */
  public DisplaySpec named(String other) {
    return new DisplaySpec(id, type, other.strip(), sources, shown, settings);
  }

  /**
   * The same from elsewhere.
   *
   * @param others where its data come from; empty to choose by itself
   * @return the other
   */
  public DisplaySpec from(List<String> others) {
    return new DisplaySpec(id, type, name, others, shown, settings);
  }

  /**
   * The same with other settings.
   *
   * @param others settings of its kind
   * @return the other
   */
  public DisplaySpec with(Map<String, Object> others) {
    return new DisplaySpec(id, type, name, sources, shown, others);
  }
}
