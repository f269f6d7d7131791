package org.robotui.core.internal.life;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Settings;
import org.robotui.core.internal.config.SchemaCheck;
import org.robotui.core.internal.support.FakeView;

class UicSettingsTest {
  private final Map<String, Object> kept = new HashMap<>();

  private UicSettings settings(Map<String, Object> chosen) {
    Settings written = new Settings(new FakeView("map").schema(), Map.of("follow", false, "zoom", 10.0));
    return new UicSettings(written, chosen, new SchemaCheck(), kept::put);
  }

  @Test
  void chosenValuesCoverWrittenOnes() {
    Settings current = settings(Map.of("zoom", 25.0)).current();
    assertEquals(25.0, current.number("zoom"));
    assertEquals(false, current.flag("follow"));
  }

  @Test
  void changeHoldsAtOnceAndIsKept() {
    UicSettings settings = settings(Map.of());
    settings.set("follow", true);
    assertTrue(settings.current().flag("follow"));
    assertEquals(Map.of("follow", true), kept);
  }

  @Test
  void changeThatDoesNotFitIsRefusedAndChangesNothing() {
    UicSettings settings = settings(Map.of());
    assertThrows(IllegalArgumentException.class, () -> settings.set("zoom", 1000.0));
    assertThrows(IllegalArgumentException.class, () -> settings.set("zoom", "near"));
    assertThrows(IllegalArgumentException.class, () -> settings.set("zom", 10.0));
    assertEquals(10.0, settings.current().number("zoom"));
    assertEquals(Map.of(), kept);
  }

  @Test
  void earlierChoicesThatDoNotFitAnyMoreAreLeftOut() {
    Settings current = settings(Map.of("zoom", 1000.0, "gone", "x", "follow", true)).current();
    assertEquals(10.0, current.number("zoom"));
    assertTrue(current.flag("follow"));
  }
}
