package org.robotui.api.host;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.robotui.api.port.SourceId;

/**
 * What shall be written for a robot.
 *
 * @param name of the RUIC, and of the robot where its interface names none
 * @param ruic the type of RUIC
 * @param views the types of the views that a window shows
 * @param connections which port goes where, for ports that several fit
 * @param file a file that is not there yet, or one to which it is added
 */
public record RuicDraft(String name, String ruic, List<String> views, Map<SourceId, SourceId> connections, Path file) {
  /**
   * Copies list and map, in their order.
   *
   * @param name of the RUIC
   * @param ruic the type of RUIC
   * @param views types of views
   * @param connections which port goes where
   * @param file where it is written
   */
  public RuicDraft {
    views = List.copyOf(views);
    connections = Collections.unmodifiableMap(new LinkedHashMap<>(connections));
  }
}
