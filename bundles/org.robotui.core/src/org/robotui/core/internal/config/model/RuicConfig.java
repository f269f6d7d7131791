package org.robotui.core.internal.config.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.layout.Layout;
import org.robotui.data.geometry.FrameTransform;

/**
 * One RUIC as written.
 *
 * @param name unique within the host
 * @param file as the user named it
 * @param line from 1, of its name
 * @param column from 1
 * @param type id of its type; empty where the file lists all views and the layout itself
 * @param raw settings for its type
 * @param rfics its robot interfaces
 * @param without views of its type that are left out
 * @param uics views that it adds to, or configures of, those of its type
 * @param connections named connections
 * @param layout where the views lie, in place of the layout of its type
 * @param perspectives other layouts, by the names that users know them by
 * @param safety by name of the robot
 * @param frames how its robots stand to one another: fixed, and never forgotten
 * @param startsShown true where nothing of it runs before it is shown for the first time
 */
public record RuicConfig(
    String name,
    String file,
    int line,
    int column,
    String type,
    RawSection raw,
    List<ComponentConfig> rfics,
    List<String> without,
    List<ComponentConfig> uics,
    List<ConnectionConfig> connections,
    Optional<Layout> layout,
    Map<String, Layout> perspectives,
    Map<String, SafetyConfig> safety,
    List<FrameTransform> frames,
    boolean startsShown) {
  /**
   * Copies the collections.
   *
   * @param name unique within the host
   * @param file as the user named it
   * @param line from 1
   * @param column from 1
   * @param type id of its type
   * @param raw settings for its type
   * @param rfics its robot interfaces
   * @param without views that are left out
   * @param uics views
   * @param connections named connections
   * @param layout where the views lie
   * @param perspectives other layouts
   * @param safety by name of the robot
   * @param frames how its robots stand to one another
   * @param startsShown whether it waits until it is shown
   */
  public RuicConfig {
    rfics = List.copyOf(rfics);
    without = List.copyOf(without);
    uics = List.copyOf(uics);
    connections = List.copyOf(connections);
    perspectives = Collections.unmodifiableMap(new LinkedHashMap<>(perspectives));
    safety = Map.copyOf(safety);
    frames = List.copyOf(frames);
  }

  /**
   * The same with another robot interface in the place of that of the same id.
   *
   * @param next the robot interface
   * @return a copy
   */
  public RuicConfig with(ComponentConfig next) {
    List<ComponentConfig> changed = rfics.stream().map(c -> c.id().equals(next.id()) ? next : c).toList();
    return new RuicConfig(name, file, line, column, type, raw, changed, without, uics, connections, layout,
        perspectives, safety, frames, startsShown);
  }

  /**
   * The same with what may be changed while it runs as another one says it: named connections, perspectives and how
   * robots are kept safe.
   *
   * @param other as written now
   * @return a copy
   */
  public RuicConfig withLiveParts(RuicConfig other) {
    return new RuicConfig(name, file, line, column, type, raw, rfics, without, uics, other.connections, layout,
        other.perspectives, other.safety, frames, startsShown);
  }

  /**
   * A robot interface by its id.
   *
   * @param id within the RUIC
   * @return its configuration, or none
   */
  public Optional<ComponentConfig> rfic(String id) {
    return rfics.stream().filter(c -> c.id().equals(id)).findFirst();
  }

  /**
   * How a robot is kept safe.
   *
   * @param robot its name
   * @return as written, else the default
   */
  public SafetyConfig safety(String robot) {
    return safety.getOrDefault(robot, SafetyConfig.DEFAULT);
  }
}
