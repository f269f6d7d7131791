package org.robotui.uic.console.internal.model;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OpenBracketsTest {
  @ParameterizedTest
  @ValueSource(strings = {"", "ports()", "'('", "\"{\" + 1", "// (", "/* ( */ 1", "`${1}`", "f)(", "'\\'('", "'open",
      "a / b", "x = 1 // [", "'a\n"})
  void whatIsWholeOrBeyondRepairIsRun(String text) {
    assertFalse(OpenBrackets.in(text));
  }

  @ParameterizedTest
  @ValueSource(strings = {"while (true) {", "f(", "[1,", "`one\ntwo", "/* still", "// done\n(", "f('(', ",
      "'a\\'' + ("})
  void whatIsOpenGoesOn(String text) {
    assertTrue(OpenBrackets.in(text));
  }
}
