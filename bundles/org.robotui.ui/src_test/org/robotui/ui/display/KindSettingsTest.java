package org.robotui.ui.display;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;

class KindSettingsTest {
  private static final Schema SCHEMA = Schema.of(
      Setting.of("frame", new ValueType.Text(TextRule.FRAME), "map", "Where it lies."));

  @Test
  void aTextThatBreaksItsRuleFallsBackAndIsSaid() {
    KindSettings checked = KindSettings.check(SCHEMA, Map.of("frame", " padded"));

    assertEquals("map", checked.settings().text("frame"));
    assertEquals(List.of("frame is  padded, must be the name of a frame, such as map or Natalie/map"),
        checked.problems());
  }

  @Test
  void whatTheSchemaDoesNotKnowIsSaid() {
    assertEquals(List.of("there is no setting 'size'"),
        KindSettings.check(SCHEMA, Map.of("frame", "odom", "size", 1L)).problems());
  }
}
