package org.robotui.api.host;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * How one robot interface of a RUIC is configured.
 *
 * @param id within its RUIC
 * @param type id of its type: the framework
 * @param robot the robot that it speaks to
 * @param title what users call it, empty where not written
 * @param settings what is written for its type, in the order of writing: texts as written, Boolean, Number, List and
 * Map
 */
public record InterfaceConfig(String id, String type, String robot, String title, Map<String, Object> settings) {
  /**
   * Copies the settings, in their order.
   *
   * @param id within its RUIC
   * @param type id of its type
   * @param robot the robot that it speaks to
   * @param title what users call it
   * @param settings what is written for its type
   */
  public InterfaceConfig {
    settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
  }
}
