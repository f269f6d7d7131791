package org.robotui.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.RuicType.UicSpec;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.Layout.Tabs;

class FixedRuicTypeTest {
  private static final Layout MAP_AND_PLOT = new Tabs(List.of("map", "plot"));

  private static RuicType type(Layout layout, String... placeless) {
    return new FixedRuicType("rover", "Rover", "A robot that drives.", layout, placeless) {};
  }

  @Test
  void itsViewsAreThoseOfTheLayoutAndThenThoseWithoutAPlace() {
    RuicType type = type(MAP_AND_PLOT, "text");
    Settings settings = new Settings(type.schema(), Map.of());

    assertEquals("rover", type.id());
    assertEquals(MAP_AND_PLOT, type.layout(settings));
    assertEquals(List.of(new UicSpec("map", "map"), new UicSpec("plot", "plot"), new UicSpec("text", "text")),
        type.uics(settings));
  }

  @Test
  void aViewThatIsNamedTwiceIsRefused() {
    Layout twice = new Tabs(List.of("map", "plot", "map"));

    assertTrue(assertThrows(IllegalArgumentException.class, () -> type(twice)).getMessage()
        .contains("'rover' names a view twice"));
    assertThrows(IllegalArgumentException.class, () -> type(MAP_AND_PLOT, "plot"));
  }
}
