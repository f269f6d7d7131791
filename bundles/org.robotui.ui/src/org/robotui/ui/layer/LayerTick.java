package org.robotui.ui.layer;

import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Placer;

/**
 * One tick of a layer.
 *
 * @param arrived what its sources sent since the last tick, in the order of arrival, and what holds still with the
 * first tick
 * @param state how its sources are: the best of those that it needs
 * @param placer finds where data lie in the fixed frame; none while no frame is known, and on the earth
 * @param origin where the plane touches the earth; none in frames, and while no place on it is known
 * @param robots where robots were found, the one of the map's commands first
 * @param entry what the list of layers says of it
 * @param nowNanos {@link System#nanoTime()}, against which age is measured
 * @param reset true where the clock of the robot jumped back: what was collected is to be forgotten
 */
public record LayerTick(
    List<Envelope<? extends Data>> arrived,
    InputState state,
    Optional<Placer> placer,
    Optional<EarthOrigin> origin,
    List<SeenRobot> robots,
    LayerEntry entry,
    long nowNanos,
    boolean reset) {
  /**
   * Copies the lists.
   *
   * @param arrived what came
   * @param state of its sources
   * @param placer of the fixed frame
   * @param origin on the earth
   * @param robots on the map
   * @param entry in the list
   * @param nowNanos now
   * @param reset forget what was collected
   */
  public LayerTick {
    arrived = List.copyOf(arrived);
    robots = List.copyOf(robots);
  }

  /**
   * The newest value of a type that came with this tick.
   *
   * @param <T> the type
   * @param type the type
   * @return the envelope, or none
   */
  @SuppressWarnings("unchecked") // the value is of the type, and an envelope only gives it out
  public <T extends Data> Optional<Envelope<T>> newest(Class<T> type) {
    return arrived.reversed().stream().filter(e -> type.isInstance(e.value())).findFirst().map(e -> (Envelope<T>) e);
  }

  /**
   * Where a robot is.
   *
   * @param name of the robot
   * @return the robot, or none where it is not on the map
   */
  public Optional<SeenRobot> robot(String name) {
    return robots.stream().filter(r -> r.name().equals(name)).findFirst();
  }

  /**
   * Its settings.
   *
   * @return checked, fallbacks included
   */
  public Settings settings() {
    return entry.settings();
  }

  /**
   * Its colour.
   *
   * @return as the list of layers says
   */
  public Ink ink() {
    return entry.ink();
  }
}
