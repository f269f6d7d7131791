package org.robotui.api.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

class FieldExpressionTest {
  private static final MapRecord RECORD = new MapRecord("demo", Map.of("x", new FieldValue.Num(1.5, "1.5"), "at",
      new FieldValue.Time(2_000_000_000L), "name", new FieldValue.Text("base"), "many",
      new FieldValue.Numbers(Doubles.of(1, 2)), "on", new FieldValue.Flag(true)));

  @ParameterizedTest
  @CsvSource(quoteCharacter = '"', value = {"x,1.5", "x * 1000,1500", "x*2-1,2", "x * -1 + 0.5,-1.0", "at * 1e-9,2",
      "on * 1 + 1,2", "many[1],2.0", "3,3", "-2.5e3,-2.5e3"})
  void numbersHaveUnits(String text, String exact) {
    FieldValue value = FieldExpression.parse(text).of(RECORD).orElseThrow();
    assertEquals(Double.parseDouble(exact), ((FieldValue.Num) value).value(), 1e-12);
  }

  @Test
  void textsAndManyNumbersPass() {
    assertEquals(Optional.of(new FieldValue.Text("base")), FieldExpression.parse("name").of(RECORD));
    assertEquals(Optional.of(new FieldValue.Text("a b")), FieldExpression.parse("'a b'").of(RECORD));
    assertEquals(Optional.of(new FieldValue.Numbers(Doubles.of(100, 200))),
        FieldExpression.parse("many * 100").of(RECORD));
    assertEquals(Optional.empty(), FieldExpression.parse("nowhere").of(RECORD));
  }

  @Test
  void aTextHasNoUnit() {
    FieldExpression expression = FieldExpression.parse("name * 2");
    assertEquals("'name' is no number: it cannot be multiplied or added to",
        assertThrows(IllegalArgumentException.class, () -> expression.of(RECORD)).getMessage());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "x *", "x + y", "2 * x", "x * 2 * 3", "a b", "'open", "x * 1e999", "[1]", "x..y"})
  void whatIsNoneIsRefused(String text) {
    assertThrows(IllegalArgumentException.class, () -> FieldExpression.parse(text));
  }

  @Test
  void everyWordHasHelp() {
    assertEquals(List.of(), BridgeWords.SCHEMA.settings().stream().filter(s -> s.help().isBlank()).toList());
  }
}
