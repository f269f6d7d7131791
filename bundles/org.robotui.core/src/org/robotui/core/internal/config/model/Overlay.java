package org.robotui.core.internal.config.model;

import java.util.Map;
import org.robotui.api.port.SourceId;

/**
 * What the user changed in one RUIC while it ran, kept beside the configuration.
 *
 * @param settings by id of the view and name of the setting: Boolean, Long, Double, String, List or Map
 * @param connections the chosen peer by port of the view
 * @param interfaces the robot interfaces that took the place of written ones, by id
 * @param views how the views are arranged
 */
public record Overlay(
    Map<String, Map<String, Object>> settings, Map<SourceId, SourceId> connections,
    Map<String, ChosenInterface> interfaces, KeptViews views) {
  /** Nothing changed. */
  public static final Overlay EMPTY = new Overlay(Map.of(), Map.of(), Map.of(), KeptViews.NONE);

  /**
   * Copies the maps.
   *
   * @param settings by view and name
   * @param connections by port
   * @param interfaces by id
   * @param views how the views are arranged
   */
  public Overlay {
    settings = Map.copyOf(settings);
    connections = Map.copyOf(connections);
    interfaces = Map.copyOf(interfaces);
  }
}
