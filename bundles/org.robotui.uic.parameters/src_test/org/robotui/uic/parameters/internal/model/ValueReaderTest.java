package org.robotui.uic.parameters.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.input.Unreadable;

class ValueReaderTest {
  @Test
  void theKindIsKept() throws Unreadable {
    assertEquals(5.0, ValueReader.read("5", 1.5));
    assertEquals(5L, ValueReader.read(" 5 ", 1L));
    assertEquals(255L, ValueReader.read("0xff", 1L));
    assertEquals("5", ValueReader.read("5", "text"));
    assertEquals(" a ", ValueReader.read(" a ", "text"));
    assertEquals(true, ValueReader.read("on", false));
    assertEquals(1.5, ValueReader.read("1,5", 0.0));
    assertEquals(Double.NEGATIVE_INFINITY, ValueReader.read("-.inf", 0.0));
  }

  @Test
  void whatIsWrongIsSaid() {
    assertEquals("'5.5' is no whole number", wrong("5.5", 1L));
    assertEquals("'1,500' is no number; decimals begin with a point", wrong("1,500", 1.0));
    assertEquals("'1e999' is too large", wrong("1e999", 1.0));
    assertEquals("'maybe' is neither true nor false", wrong("maybe", true));
    assertEquals("',' or ']' is expected at the end", wrong("[1, 2", List.of()));
    assertEquals("':' after 'x' is expected at character 3, there is '}'", wrong("{x}", Map.of()));
    assertEquals("the end is expected at character 4, there is '5'", wrong("[] 5", List.of()));
    assertEquals("The quote at character 2 is never closed", wrong("[\"a", List.of()));
    assertEquals("'a' stands there twice", wrong("{a: 1, a: 2}", Map.of()));
    assertEquals("'010' is no whole number; write it without zeros in front", wrong("[1, 010]", List.of()));
    assertEquals("Write a list, for example [1, 2, 3]", wrong("5", List.of(1L)));
  }

  @Test
  void numbersOfListsStayReal() throws Unreadable {
    assertEquals(List.of(1.0, 2.0, 3.5), ValueReader.read("[1, 2, 3.5]", List.of(0.5)));
    assertEquals(List.of(1L, 2L), ValueReader.read("[1, 2]", List.of(3L)));
    assertEquals(Map.of("p", 1.0, "i", 2L), ValueReader.read("{p: 1, i: 2}", Map.of("p", 0.5, "i", 1L)));
  }

  @Test
  void listsAndMapsNest() throws Unreadable {
    assertEquals(List.of(Map.of("a b", List.of("x", true)), "it's"),
        ValueReader.read("[{'a b': [x, true]}, \"it's\"]", List.of()));
  }

  @Test
  void whatIsWrittenIsReadAgain() throws Unreadable {
    Map<String, Object> value =
        Map.of("n", List.of(1L, 2.5, true, "true", "1", "a\n\"b\"", "", "x: y", "-"), "e", Map.of(), "l", List.of());
    assertEquals(value, ValueReader.read(ValueText.of(value), value));
  }

  @Test
  void deepAndLongInputIsRefused() {
    assertTrue(wrong("[".repeat(50_000), List.of()).contains("too many"));
    assertTrue(wrong("[" + "1,".repeat(100_000), List.of()).contains("too many"));
  }

  private static String wrong(String text, Object like) {
    return assertThrows(Unreadable.class, () -> ValueReader.read(text, like)).getMessage();
  }
}
