package org.robotui.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class FiguresTest {
  @Test
  void hugeFiguresAreShort() {
    assertEquals("1.000e300", Figures.fixed(1e300, 6));
    assertEquals("\u22121.798e308\u00a0m", Figures.of(-Double.MAX_VALUE, 2, "m"));
    assertEquals("999999999999.0", Figures.fixed(999_999_999_999.0, 1));
  }

  @Test
  void noValueIsYoungerThanNow() {
    assertEquals("0\u00a0ms", Figures.ageOfValue(-0.02));
    assertEquals("\u22123.0\u00a0s", Figures.ageOfValue(-3));
    assertEquals("20\u00a0ms", Figures.ageOfValue(0.02));
  }

  @Test
  void decimalsAreFixedAndMinusIsReal() {
    assertEquals("\u22120.18", Figures.fixed(-0.1849, 2));
    assertEquals("0.31\u00a0m/s", Figures.of(0.31, 2, "m/s"));
    assertEquals("3", Figures.of(3.2, 0, ""));
  }

  @Test
  void whatRoundsToZeroHasNoSign() {
    assertEquals("0.00", Figures.fixed(-0.0001, 2));
    assertEquals("0.00", Figures.fixed(-0.0, 2));
  }

  @Test
  void numbersThatAreNoneAreSaidSo() {
    assertEquals("\u2014", Figures.fixed(Double.NaN, 2));
    assertEquals("\u2212\u221e", Figures.fixed(Double.NEGATIVE_INFINITY, 2));
  }

  @Test
  void anglesAreShownInDegrees() {
    assertEquals("\u221290.0\u00b0", Figures.degrees(-Math.PI / 2, 1));
  }

  @Test
  void agesAreAsExactAsTheyMatter() {
    assertEquals("12\u00a0ms", Figures.age(0.012));
    assertEquals("2.1\u00a0s", Figures.age(2.1));
    assertEquals("42\u00a0s", Figures.age(42.4));
    assertEquals("14\u00a0min", Figures.age(14 * 60));
    assertEquals("3.5\u00a0h", Figures.age(3.5 * 3600));
    assertEquals("\u2014\u00a0s", Figures.age(Double.NaN));
  }

  @Test
  void aRateThatCannotBeToldIsADash() {
    assertEquals("\u2014", Figures.rate(0));
    assertEquals("10.0\u00a0Hz", Figures.rate(10));
  }
}
