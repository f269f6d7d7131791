package org.robotui.ui.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.ValueType;
import org.robotui.api.input.Unreadable;

class SettingEditorTest {
  private static final ValueType METRES = new ValueType.Num(0, 10, "m");
  private static final ValueType COUNT = new ValueType.Int(0, 100);

  @Test
  void whatFitsIsReadAsSettingsHoldIt() throws Unreadable {
    assertEquals(1.5, SettingEditor.read(METRES, " 1,5 "));
    assertEquals(16L, SettingEditor.read(COUNT, "0x10"));
    assertEquals(true, SettingEditor.read(new ValueType.Flag(), "yes"));
    assertEquals(List.of(1.0, 5.0), SettingEditor.read(new ValueType.ListOf(METRES), "1,5"));
    assertEquals(List.of(), SettingEditor.read(new ValueType.ListOf(METRES), " "));
    assertEquals("auto", SettingEditor.read(new ValueType.AnyOf(List.of(METRES, new ValueType.Text())), "auto"));
  }

  @Test
  void whatDoesNotFitIsSaidInTheWordsOfAllFields() {
    assertEquals("is too large", fault(METRES, "1e400"));
    assertEquals("is no finite number", fault(METRES, "NaN"));
    assertEquals("is no number", fault(METRES, "0x10"));
    assertEquals("is no whole number", fault(COUNT, "5.0"));
    assertEquals("must be a number from 0 to 10 in m", fault(METRES, "11"));
    assertEquals("must be a whole number from 0 to 100", fault(COUNT, "101"));
    assertEquals("must be one of a, b", fault(new ValueType.Choice(List.of("a", "b")), "c"));
    assertEquals("is no number", fault(new ValueType.ListOf(METRES), "1,,2"));
    assertEquals("must be a number from 0 to 10 in m, or true or false",
        fault(new ValueType.AnyOf(List.of(METRES, new ValueType.Flag())), "far"));
    assertEquals("cannot be typed in one line", fault(new ValueType.MapOf(METRES), "a: 1"));
  }

  private static String fault(ValueType type, String typed) {
    return assertThrows(Unreadable.class, () -> SettingEditor.read(type, typed)).getMessage();
  }
}
