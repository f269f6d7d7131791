package org.robotui.uic.scene3d.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Settings;
import org.robotui.gl.shape.Rgba;
import org.robotui.uic.scene3d.internal.SceneOptions;

/** A robot has the colour of its place among the robots, whichever is seen first. */
class RobotColorsTest {
  private static Settings settings(Map<String, Object> colors) {
    Map<String, Object> values = new HashMap<>();
    values.put(SceneOptions.COLORS, colors);
    return new Settings(SceneOptions.schema(), values);
  }

  @Test
  void theOrderOfTheRobotUiCountsAndOthersComeAfter() {
    RobotColors early = new RobotColors(List.of("a", "b"));
    RobotColors late = new RobotColors(List.of("a", "b"));
    Rgba stranger = early.of("c", settings(Map.of()));
    Rgba second = early.of("b", settings(Map.of()));
    assertEquals(late.of("b", settings(Map.of())), second);
    assertNotEquals(second, stranger);
    assertNotEquals(late.of("a", settings(Map.of())), stranger);
  }

  @Test
  void whatIsConfiguredHolds() {
    assertEquals(Rgba.of(0x3ecf8e), new RobotColors(List.of()).of("a", settings(Map.of("a", "#3ecf8e"))));
  }
}
