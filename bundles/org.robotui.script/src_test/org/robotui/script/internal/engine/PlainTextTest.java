package org.robotui.script.internal.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class PlainTextTest {
  @Test
  void lettersOfAllLanguagesStayAsTheyAre() {
    assertEquals("\"58\u00b0 \u4f60\u597d\"", PlainText.of("58\u00b0 \u4f60\u597d"));
  }

  @Test
  void whatWouldEndATextOrSteerATerminalIsEscaped() {
    assertEquals("[\"a\\\"b\\\\c\\nd\\te\", \"\\u001b[2J\\u202e\"]",
        PlainText.of(List.of("a\"b\\c\nd\te", "\u001b[2J\u202e")));
  }

  @Test
  void namesThatNeedQuotesHaveThem() {
    assertEquals("{\"base.odom\": 1}", PlainText.of(Map.of("base.odom", 1.0)));
  }

  @Test
  void whatIsLongIsCutAndSaysSo() {
    String text = PlainText.of("x".repeat(1_000_000));
    assertTrue(text.length() < 21_000 && text.contains("(cut after 20000 characters)"), text.length() + "");
  }
}
