package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.gl.shape.Rgba;
import org.robotui.uic.scene3d.internal.SceneOptions;

/**
 * Colours of robots: as configured, else in the order of the robot UI, as in its map and its table; others in the order
 * in which they are seen first. Worker thread.
 */
final class RobotColors {
  /** Told apart by colour-blind eyes too. */
  private static final List<Integer> COLORS =
      List.of(0x4da3ff, 0xff9f43, 0x3fb68b, 0xb084eb, 0xb07d5b, 0xe86fa8, 0x9aa5b1);
  private static final int HEX = 16;

  private final List<String> robots;

  RobotColors(List<String> robots) {
    this.robots = new ArrayList<>(robots);
  }

  Rgba of(String robot, Settings settings) {
    return configured(robot, settings.map(SceneOptions.COLORS))
        .orElseGet(() -> Rgba.of(COLORS.get(number(robot) % COLORS.size())));
  }

  private int number(String robot) {
    if (!robots.contains(robot)) {
      robots.add(robot);
    }
    return robots.indexOf(robot);
  }

  private static Optional<Rgba> configured(String robot, Map<?, ?> colors) {
    return Optional.ofNullable(colors.get(robot)).map(Object::toString).filter(c -> c.matches("#[0-9a-fA-F]{6}"))
        .map(c -> Rgba.of(Integer.parseInt(c.substring(1), HEX)));
  }
}
