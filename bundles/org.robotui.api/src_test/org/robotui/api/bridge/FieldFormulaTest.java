package org.robotui.api.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

class FieldFormulaTest {
  private static final MapRecord RECORD = new MapRecord("demo",
      Map.of("x", new FieldValue.Num(3, "3"), "y", new FieldValue.Num(4, "4"), "at",
          new FieldValue.Time(2_000_000_000L), "name", new FieldValue.Text("base"), "many",
          new FieldValue.Numbers(Doubles.of(1, 2)), "on", new FieldValue.Flag(true)));

  private static double number(String text) {
    return ((FieldValue.Num) FieldFormula.parse(text).of(RECORD).orElseThrow()).value();
  }

  @ParameterizedTest
  @CsvSource(quoteCharacter = '"', delimiter = ';', value = {"x;3", "x * 1000 + 5;3005", "2 * x;6", "x + y;7",
      "x - y - 1;-2", "x*2-1-1;4", "2 * (x - y);-2", "-x;-3", "x / y / 2;0.375", "1 - x * y;-11", "--2;2",
      "sqrt(x*x + y*y);5", "atan2(x, 0) * 2;3.141592653589793", "max(x, min(y, 10));4", "abs(-x);3", "deg(rad(x));3",
      "at / 1e9 + on;3", "many[1] * x;6", ".5 * x;1.5", "round(x / 2);2"})
  void numbersAreCalculated(String text, double expected) {
    assertEquals(expected, number(text), 1e-12);
  }

  @Test
  void textsAndManyNumbersPassAsTheyAre() {
    assertEquals(Optional.of(new FieldValue.Text("base")), FieldFormula.parse("name").of(RECORD));
    assertEquals(Optional.of(new FieldValue.Text("a + b")), FieldFormula.parse("'a + b'").of(RECORD));
    assertEquals(Optional.of(new FieldValue.Numbers(Doubles.of(2, 4))), FieldFormula.parse("many * 2").of(RECORD));
  }

  @Test
  void whatIsNotThereIsNamed() {
    FieldFormula formula = FieldFormula.parse("x + inner.z");
    assertEquals(Optional.empty(), formula.of(RECORD));
    assertEquals(Optional.of("inner.z"), formula.missing(RECORD));
    assertEquals(Optional.empty(), FieldFormula.parse("x + y").missing(RECORD));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1 / (x - 3)", "0 / (x - 3)", "sqrt(-x)"})
  void whatIsNotFiniteIsRefused(String text) {
    FieldFormula formula = FieldFormula.parse(text);
    assertTrue(assertThrows(IllegalArgumentException.class, () -> formula.of(RECORD)).getMessage().contains(text));
  }

  @Test
  void nothingIsCalculatedOfTexts() {
    FieldFormula formula = FieldFormula.parse("1 + name");
    assertEquals("'name' is no number: nothing can be calculated of it",
        assertThrows(IllegalArgumentException.class, () -> formula.of(RECORD)).getMessage());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " ", "x *", "x + ", "a b", "'open", "x * 1e999", "[1]", "x..y", "(x", "x)", "min(x)",
      "sqrt(x, y)", "max(x, y, 1)", "nothing(x)", "x ** y", "2x", "x % 2", "sqrt x"})
  void whatIsNoneIsRefused(String text) {
    assertThrows(IllegalArgumentException.class, () -> FieldFormula.parse(text));
  }

  @Test
  void nothingIsReadWithoutEnd() {
    String deep = "(".repeat(100_000);
    assertThrows(IllegalArgumentException.class, () -> FieldFormula.parse(deep));
    assertEquals(1, number("(".repeat(200) + "1" + ")".repeat(200)));
  }
}
