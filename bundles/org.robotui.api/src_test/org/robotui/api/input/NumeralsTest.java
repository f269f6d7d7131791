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

  @ParameterizedTest
  @ValueSource(strings = {"1,5", " 1", "1 ", "1d", "NaN", "Infinity", "1e400", "\u22121", "0x1p3", "", "."})
  void whatPeopleTypeIsNotTakenFromFiles(String text) {
    assertEquals(Optional.empty(), Numerals.decimal(text));
    assertEquals(Optional.empty(), Numerals.whole(text));
  }
}
