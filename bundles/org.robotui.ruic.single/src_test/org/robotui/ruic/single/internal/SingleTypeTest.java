package org.robotui.ruic.single.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.RuicType.UicSpec;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout.View;

class SingleTypeTest {
  private final SingleType type = new SingleType();

  @Test
  void showsTheViewThatIsNamed() {
    Settings camera = new Settings(type.schema(), Map.of("view", "camera"));

    assertEquals(List.of(new UicSpec("camera", "camera")), type.uics(camera));
    assertEquals(new View("camera"), type.layout(camera));
  }

  @Test
  void showsTheMapWhereNothingIsNamed() {
    Object fallback = type.schema().find("view").orElseThrow().fallback().orElseThrow();

    assertEquals("map", fallback);
  }
}
