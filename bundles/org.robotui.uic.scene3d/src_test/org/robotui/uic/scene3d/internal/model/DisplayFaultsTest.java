package org.robotui.uic.scene3d.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Placed;
import org.robotui.api.config.SettingFault;
import org.robotui.data.sensor.LaserScan;
import org.robotui.testkit.FakeSettings;
import org.robotui.ui.display.DisplayCodec;
import org.robotui.ui.display.DisplayFaults;
import org.robotui.uic.scene3d.internal.SceneOptions;

class DisplayFaultsTest {
  private final FakeSettings settings = new FakeSettings(SceneOptions.schema());

  @Test
  void settingsOfADisplayAreJudgedByItsKindWhereTheyAreWritten() {
    assertEquals(List.of(), faults("scan", Map.of("size", placed(5.0, 3))));
    assertEquals(List.of("robot.yaml:3:7: display 'scan': size is 1.0E308, must be a number from 0 to 10 in m"),
        faults("scan", Map.of("size", placed(1e308, 3))));
    String file = faults("scan", Map.of("file", placed("/etc/passwd", 4))).getFirst();
    assertEquals("robot.yaml:4:7: display 'scan': there is no setting 'file'; there are size",
        file.substring(0, file.indexOf("size") + 4));
  }

  @Test
  void aKindThatIsNotThereIsToldByTheScene() {
    assertEquals(List.of(), faults("later", Map.of("size", placed(1e308, 3))));
  }

  @Test
  void aDisplayHasItsSettingsWithoutTheirPlaces() {
    faults("scan", Map.of("size", placed(5.0, 3)));
    assertEquals(Map.of("size", 5.0),
        DisplayCodec.read(settings.current(), SceneOptions.DISPLAYS).getFirst().settings());
  }

  private static Placed placed(Object value, int line) {
    return new Placed(value, "robot.yaml", line, 7);
  }

  private List<String> faults(String type, Map<String, Object> values) {
    settings.set(SceneOptions.DISPLAYS, List.of(Map.of("type", type, "settings", values)));
    return DisplayFaults
        .of(settings.current(), SceneOptions.DISPLAYS, "display",
            Kinds.of(List.of(new FakeKind("scan", List.of(LaserScan.class)))))
        .stream().map(SettingFault::toString).toList();
  }
}
