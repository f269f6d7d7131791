package org.robotui.api.port;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StreamFieldTest {
  @Test
  void aPortMayHaveColonsAndDots() {
    StreamField field = StreamField.parse("base.laser.front:0:ranges[3].range");
    assertEquals(new SourceId("base", "laser.front:0"), field.source());
    assertEquals("ranges[3].range", field.path().toString());
    assertEquals("base.laser.front:0:ranges[3].range", field.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "odom", "base.odom", "base.odom:", ".odom:x", "base.:x", ":"})
  void whatNamesNoFieldIsRefusedWithAnExample(String text) {
    String said = assertThrows(IllegalArgumentException.class, () -> StreamField.parse(text)).getMessage();
    assertTrue(said.contains("write SOURCE:PATH"), said);
  }
}
