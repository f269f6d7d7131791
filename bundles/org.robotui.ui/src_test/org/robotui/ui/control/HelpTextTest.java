package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;

class HelpTextTest {
  @Test
  void phrasesBecomeSentencesAndSentencesStay() {
    assertEquals("How long a command holds.", of("how long a command holds"));
    assertEquals("Where it is (0 for the start).", of("where it is (0 for the start)"));
    assertEquals("Whether it is shown.", of("Whether it is shown."));
    assertEquals("/scan or another topic.", of("/scan or another topic"));
    assertEquals("max_linear of the robot.", of("max_linear of the robot"));
    assertEquals("", of(" "));
  }

  private static String of(String help) {
    return HelpText.of(Setting.optional("it", new ValueType.Text(), help));
  }
}
