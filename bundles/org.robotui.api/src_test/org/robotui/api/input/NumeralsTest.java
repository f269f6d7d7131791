package org.robotui.api.input;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigInteger;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class NumeralsTest {
  @Test
  void filesHaveNumbersInOneForm() {
    assertEquals(Optional.of(-1.5e3), Numerals.decimal("-1.5e3"));
    assertEquals(Optional.of(BigInteger.valueOf(-255)), Numerals.whole("-0xFF"));
  }

  @Test
  void whatIsWrittenReadsAsTheSameNumber() {
    for (double value : new double[]{0, 1, -2, 0.1, 1e9 + 1, -1e15, 1.5e300, Double.MIN_VALUE, 1 / 3.0}) {
      assertEquals(Optional.of(value), Numerals.decimal(Numerals.text(value)));
    }
    assertEquals("-2", Numerals.text(-2));
    assertEquals("999999999999999", Numerals.text(1e15 - 1));
    assertEquals("1.0E15", Numerals.text(1e15));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1,5", " 1", "1 ", "1d", "NaN", "Infinity", "1e400", "\u22121", "0x1p3", "", "."})
  void whatPeopleTypeIsNotTakenFromFiles(String text) {
    assertEquals(Optional.empty(), Numerals.decimal(text));
    assertEquals(Optional.empty(), Numerals.whole(text));
  }
}
