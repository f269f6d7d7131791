package org.robotui.api.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TypedTextTest {
  @ParameterizedTest
  @CsvSource(delimiter = '|', ignoreLeadingAndTrailingWhitespace = false, value = {"0|0", " 1.5 |1.5", "\t2 |2",
      "+.5|0.5",
      "5.|5", "-1e-3|-0.001", "1,5|1.5", "\u22120,5|-0.5", "0,500|0.5", "1234,567|1234.567", "1,5e3|1500", ",5|0.5",
      "1e308|1e308", "1e-400|0", "007.5|7.5"})
  void numbersAreRead(String typed, double value) throws Unreadable {
    assertEquals(value, TypedText.finite(typed));
    assertEquals(value, TypedText.real(typed));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {"1e400|is too large", "-1e400|is too large", "0x10|is no number",
      "0x1p3|is no number", "1d|is no number", "1.5F|is no number", "''|is no number", "1 5|is no number",
      "- 5|is no number", "1'000|is no number", "\u0661|is no number",
      "1,500|is no number; decimals begin with a point",
      "1.000,5|is no number; decimals begin with a point", "1,2,3|is no number; decimals begin with a point",
      "1,|is no number; decimals begin with a point"})
  void whatIsNoNumberIsSaid(String typed, String fault) {
    assertEquals(fault, assertThrows(Unreadable.class, () -> TypedText.real(typed)).getMessage());
    assertEquals(fault, assertThrows(Unreadable.class, () -> TypedText.finite(typed)).getMessage());
  }

  @ParameterizedTest
  @CsvSource({"NaN,NaN", ".nan,NaN", "inf,Infinity", "+Inf,Infinity", " -.INF ,-Infinity", "Infinity,Infinity",
      "\u2212infinity,-Infinity"})
  void onlyRobotsMeanNumbersThatAreNotFinite(String typed, double value) throws Unreadable {
    assertEquals(value, TypedText.real(typed));
    assertEquals("is no finite number", assertThrows(Unreadable.class, () -> TypedText.finite(typed)).getMessage());
  }

  @Test
  void boundsAreSaidInTheWordsOfTheField() throws Unreadable {
    assertEquals(50, TypedText.within("50", 0.1, 50, "from 0.1 to 50 Hz"));
    Unreadable fault = assertThrows(Unreadable.class, () -> TypedText.within("50,1", 0.1, 50, "from 0.1 to 50 Hz"));
    assertEquals("must be from 0.1 to 50 Hz", fault.getMessage());
    assertThrows(Unreadable.class, () -> TypedText.within("NaN", 0.1, 50, ""));
  }

  @ParameterizedTest
  @CsvSource({"0,0", " 12 ,12", "+3,3", "\u22123,-3", "0x10,16", "0XfF,255", "-0x10,-16",
      "9223372036854775807,9223372036854775807", "-9223372036854775808,-9223372036854775808"})
  void wholeNumbersAreRead(String typed, long value) throws Unreadable {
    assertEquals(value, TypedText.whole(typed));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {"1.0|is no whole number", "1e3|is no whole number", "1,5|is no whole number",
      "0x|is no whole number", "''|is no whole number", "1 000|is no whole number", "NaN|is no whole number",
      "010|is no whole number; write it without zeros in front",
      "9223372036854775808|must be from -9223372036854775808 to 9223372036854775807"})
  void whatIsNoWholeNumberIsSaid(String typed, String fault) {
    assertEquals(fault, assertThrows(Unreadable.class, () -> TypedText.whole(typed)).getMessage());
  }

  @Test
  void longInputIsRefusedAtOnce() {
    String digits = "9".repeat(1_000_000);
    assertThrows(Unreadable.class, () -> TypedText.whole(digits));
    assertThrows(Unreadable.class, () -> TypedText.real(digits + ",5"));
    BigInteger most = BigInteger.ONE.shiftLeft(64);
    assertThrows(Unreadable.class, () -> TypedText.whole("0x" + "f".repeat(17), BigInteger.ZERO, most));
  }

  @ParameterizedTest
  @ValueSource(strings = {"true", " Yes", "ON", "1"})
  void flagsAreRead(String typed) throws Unreadable {
    assertTrue(TypedText.flag(typed));
    for (String no : new String[]{"false", "no ", "Off", "0"}) {
      assertEquals(false, TypedText.flag(no));
    }
    assertEquals("is neither true nor false",
        assertThrows(Unreadable.class, () -> TypedText.flag("maybe")).getMessage());
  }
}
