package org.robotui.ruic.cockpit.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.RuicType.UicSpec;
import org.robotui.api.config.Settings;

class CockpitTypeTest {

  private final CockpitType type = new CockpitType();
  private final Settings settings = new Settings(type.schema(), Map.of());

  @Test
  void the_view_that_matters_most_comes_first() {
    assertEquals("camera", type.uics(settings).getFirst().id());
  }

  @Test
  void each_view_of_the_layout_is_made() {
    List<String> made = type.uics(settings).stream().map(UicSpec::id).toList();

    assertTrue(made.containsAll(type.layout(settings).views()));
    assertTrue(made.contains("text"), "a terminal needs a view, too");
  }
}
