package org.robotui.ros.reconfigure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.testkit.Effort;

class PythonLiteralTest {

  private static final String CHOICES =
      "{'enum': [{'name': 'Small', 'type': 'int', 'value': 0, 'srcline': 44, 'srcfile': 'Test.cfg',"
          + " 'description': \"A 'small' constant\", 'ctype': 'int'}, {'name': u'La\\u00e9', 'value': 2, 'description': 'tab\\there'}],"
          + " 'enum_description': 'sets\\nthe size'}";

  @Test
  void valuesAreReadAsData() throws Exception {
    assertEquals(Map.of("a", List.of(1L, -2.5, true, Optional.empty()), "b", List.of("x", 3L), 4L, List.of()),
        PythonLiteral.parse(" {'a': [1, -2.5, True, None,], \"b\": (b'x', 3L), 4: []} "));
    assertEquals("a'b\"c\\d\u00e9\ud83e\udd16\\q", PythonLiteral.parse("'a\\'b\"c\\\\d\\xe9\\U0001f916\\q'"));
    assertEquals(Double.NEGATIVE_INFINITY, PythonLiteral.parse("-inf"));
    assertEquals(1e-3, PythonLiteral.parse("1e-3"));
  }

  @Test
  void choicesAreReadWithTheirTexts() {
    EditMethod method = EditMethod.read(CHOICES, ConfigKind.WHOLE);
    assertEquals(List.of(new ConfigChoice("Small", new ConfigValue.Whole(0), "A 'small' constant"),
        new ConfigChoice("La\u00e9", new ConfigValue.Whole(2), "tab\there")), method.choices());
    assertEquals("sets\nthe size", method.description());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "{", "[1", "'a", "{1}", "[1 2]", "os.system('x')", "__import__", "1.2.3", "'\\x1'",
      "'\\U99999999'", "[1]]", "u", "--1"})
  void otherTextsAreRefusedWithTheirPosition(String text) {
    String message = assertThrows(PythonLiteral.SyntaxException.class, () -> PythonLiteral.parse(text)).getMessage();
    assertTrue(message.startsWith("expected "), message);
    assertEquals(List.of(), EditMethod.read(text, ConfigKind.WHOLE).choices());
  }

  @Test
  @Timeout(10)
  void boundsHold() {
    assertThrows(PythonLiteral.SyntaxException.class, () -> PythonLiteral.parse("[".repeat(200_000)));
    assertThrows(PythonLiteral.SyntaxException.class, () -> PythonLiteral.parse("[" + "1,".repeat(50_000) + "]"));
    assertThrows(PythonLiteral.SyntaxException.class,
        () -> PythonLiteral.parse("'" + "x".repeat(PythonLiteral.MAX_TEXT) + "'"));
  }

  @Test
  @Timeout(300)
  void damagedTextsAreReadOrRefused() {
    SplittableRandom random = new SplittableRandom(2026);
    int refused = 0;
    int rounds = Effort.rounds(20_000);
    for (int round = 0; round < rounds; round++) {
      StringBuilder text = new StringBuilder(CHOICES);
      for (int i = 0; i < 3; i++) {
        int at = random.nextInt(text.length());
        switch (random.nextInt(3)) {
          case 0 -> text.delete(at, Math.min(text.length(), at + random.nextInt(20)));
          case 1 -> text.insert(at, "{[('\"\\,:".charAt(random.nextInt(8)));
          default -> text.setCharAt(at, (char) random.nextInt(1, 0x3000));
        }
      }
      refused += isRead(text.toString()) ? 0 : 1;
    }
    assertTrue(refused > rounds / 4 && refused < rounds, refused + " of " + rounds);
  }

  private static boolean isRead(String text) {
    try {
      PythonLiteral.parse(text);
      return true;
    } catch (PythonLiteral.SyntaxException e) {
      return false;
    }
  }
}
