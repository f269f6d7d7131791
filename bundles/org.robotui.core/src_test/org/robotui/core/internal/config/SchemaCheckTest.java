package org.robotui.core.internal.config;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Setting;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.core.internal.config.model.CheckedValue;

class SchemaCheckTest {
  private static final Setting PLAIN = Setting.optional("plain",
      new ValueType.AnyOf(List.of(new ValueType.Flag(), new ValueType.Int(0, Long.MAX_VALUE), new ValueType.Text())),
      "A value of any kind.");

  @Test
  void aTextStaysATextWhereNumbersMayStand() {
    for (String text : List.of("#4da3ff", "007", "0x10", "word")) {
      assertEquals(new CheckedValue.Fits(text), new SchemaCheck().value(PLAIN, text));
    }
    assertEquals(new CheckedValue.Fits(7L), new SchemaCheck().value(PLAIN, 7L));
    assertEquals(new CheckedValue.Fits(true), new SchemaCheck().value(PLAIN, true));
  }

  @Test
  void theSyntaxOfATextHoldsInEveryShapeOfASetting() {
    ValueType word = new ValueType.Text(TextRule.readBy("a word, such as go", text -> {
      if (text.contains(" ")) {
        throw new IllegalArgumentException("a blank separates words");
      }
    }));
    Setting words =
        Setting.optional("words", new ValueType.AnyOf(List.of(word, new ValueType.ListOf(word))), "One word or some.");

    assertEquals(new CheckedValue.Fits("go"), new SchemaCheck().value(words, "go"));
    CheckedValue wrong =
        new CheckedValue.Wrong("'words' must be a word, such as go, not 'go on'; a blank separates words");
    assertEquals(wrong, new SchemaCheck().value(words, "go on"));
    assertEquals(wrong, new SchemaCheck().value(words, List.of("go", "go on")));
  }
}
