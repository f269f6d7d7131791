package org.robotui.core.internal.config.model;

import java.util.Map;
import org.robotui.api.layout.Arrangement;

/**
 * A perspective as it is given to others.
 *
 * @param name what its users call it
 * @param arrangement where its views lie; none are added, as {@code views} says what each is
 * @param views what lies there, by id
 */
public record PerspectiveFile(String name, Arrangement arrangement, Map<String, View> views) {
  /**
   * A view.
   *
   * @param type id of its type
   * @param settings those that are not as they would be anyway: Boolean, Long, Double, String, List or Map
   */
  public record View(String type, Map<String, Object> settings) {
    /**
     * Copies the map.
     *
     * @param type id of its type
     * @param settings those that were chosen
     */
    public View {
      settings = Map.copyOf(settings);
    }
  }

  /**
   * Copies the map.
   *
   * @param name what its users call it
   * @param arrangement where its views lie
   * @param views what lies there
   */
  public PerspectiveFile {
    views = Map.copyOf(views);
  }
}
