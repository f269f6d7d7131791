package org.robotui.core.internal.config.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A robot interface that the user has put in the place of a written one.
 *
 * @param type id of its type
 * @param robot the robot that it speaks to
 * @param settings what it is configured with
 * @param insteadOf a mark of what was written then; where the file says something else by now, the file is newer and
 * holds
 */
public record ChosenInterface(String type, String robot, Map<String, Object> settings, String insteadOf) {
  /**
   * Copies the settings, in their order.
   *
   * @param type id of its type
   * @param robot the robot that it speaks to
   * @param settings what it is configured with
   * @param insteadOf a mark of what was written then
   */
  public ChosenInterface {
    settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
  }
}
