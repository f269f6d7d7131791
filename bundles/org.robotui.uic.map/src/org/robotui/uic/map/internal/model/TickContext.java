package org.robotui.uic.map.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Placer;
import org.robotui.uic.map.internal.MapOptions;

/**
 * What all feeds share in one tick.
 *
 * @param nowNanos the time of the tick
 * @param options the settings in force
 * @param placer finds where data lie; none while no frame is known
 * @param robots where robots were found in this tick
 */
public record TickContext(long nowNanos, MapOptions options, Optional<Placer> placer, List<RobotPlace> robots) {
  /** The same, with robots. */
  TickContext with(List<RobotPlace> found) {
    return new TickContext(nowNanos, options, placer, found);
  }

  /** Where a robot is. */
  Optional<RobotPlace> robot(String name) {
    return robots.stream().filter(r -> r.robot().equals(name)).findFirst();
  }

  /** Where a robot is, as a point. */
  Optional<Vector3> position(String name) {
    return robot(name).map(r -> r.fixedFromBase().translation());
  }
}
