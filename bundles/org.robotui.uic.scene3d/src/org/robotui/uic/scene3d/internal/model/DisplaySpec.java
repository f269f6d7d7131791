package org.robotui.uic.scene3d.internal.model;

import java.util.List;
import java.util.Map;

/**
 * A display as it is written in the settings.
 *
 * @param id tells displays apart while names and order change
 * @param type its kind
 * @param name in the list; empty for that of its kind
 * @param sources where its data come from; empty to choose by itself
 * @param shown whether it is to be seen
 * @param settings of its kind, as written
 */
public record DisplaySpec(String id, String type, String name, List<String> sources, boolean shown,
    Map<String, Object> settings) {
  /** Copies the collections. */
  public DisplaySpec {
    sources = List.copyOf(sources);
    settings = Map.copyOf(settings);
  }

  /** A display as it comes. */
  public static DisplaySpec of(String id, String type) {
    return new DisplaySpec(id, type, "", List.of(), true, Map.of());
  }

  /** The same, switched. */
  public DisplaySpec show(boolean on) {
    return new DisplaySpec(id, type, name, sources, on, settings);
  }

  /** The same under another name. */
  public DisplaySpec named(String other) {
    return new DisplaySpec(id, type, other.strip(), sources, shown, settings);
  }

  /** The same from elsewhere. */
  public DisplaySpec from(List<String> others) {
    return new DisplaySpec(id, type, name, others, shown, settings);
  }

  /** The same with other settings. */
  public DisplaySpec with(Map<String, Object> others) {
    return new DisplaySpec(id, type, name, sources, shown, others);
  }
}
