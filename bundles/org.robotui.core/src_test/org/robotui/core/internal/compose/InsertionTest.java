package org.robotui.core.internal.compose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class InsertionTest {
  private static final List<String> RUIC = List.of("Keira:", "  type: base");

  private static String into(String text) {
    Insertion insertion = Insertion.into(text, RUIC).orElseThrow();
    List<String> lines = insertion.whole().lines().toList();
    assertEquals(insertion.added().lines().findFirst(), lines.stream().skip(insertion.line() - 1L).findFirst(),
        "the line of what is new");
    String without = String.join("\n", lines.subList(0, insertion.line() - 1)) + "\n"
        + String.join("\n",
            lines.subList(insertion.line() - 1 + (int) insertion.added().lines().count(), lines.size()));
    assertEquals(text.lines().toList(), without.stripTrailing().lines().toList(), "what was there");
    return insertion.whole();
  }

  @Test
  void itStandsBehindTheLastOneAndCommentsStayWhereTheyBelong() {
    assertEquals(
        "# head\nruics:   # all\n  A:\n    type: base\n    # of A\n  Keira:\n    type: base\n\n# of windows\nwindows: [A]\n",
        into("# head\nruics:   # all\n  A:\n    type: base\n    # of A\n\n# of windows\nwindows: [A]\n"));
  }

  @Test
  void indentationAndEndsOfLinesAreThoseOfTheFile() {
    assertEquals("ruics:\r\n    A: {type: base}\r\n    Keira:\r\n      type: base\r\n",
        into("ruics:\r\n    A: {type: base}\r\n"));
  }

  @Test
  void aFileWithoutAnEndOfItsLastLineGetsOne() {
    assertEquals("ruics:\n  A: {type: base}\n  Keira:\n    type: base\n", into("ruics:\n  A: {type: base}"));
  }

  @Test
  void whatHasNoRuicsYetGetsThem() {
    assertEquals("# only words\nruics:\n  Keira:\n    type: base\n", into("# only words\n"));
    assertEquals("ruics:\n  Keira:\n    type: base\n", into("ruics:\n"));
    assertEquals("simulator: mobile-base\nruics:\n  Keira:\n    type: base\n", into("simulator: mobile-base\n"));
  }

  @Test
  void whatStandsInBracesIsLeftAlone() {
    assertTrue(Insertion.into("ruics: {A: {type: base}}\n", RUIC).isEmpty());
    assertTrue(Insertion.into("ruics: {\n  A: {type: base},\n}\n", RUIC).isEmpty());
    assertTrue(Insertion.into("ruics: {\n}\n", RUIC).isEmpty());
    assertTrue(Insertion.into("ruics:   # below\n  {A: {type: base}}\n", RUIC).isEmpty());
    assertEquals(3, Insertion.sectionLine("# head\n\nruics: {A: {type: base}}\n"));
  }

  @Test
  void emptyBracesMakeRoom() {
    Insertion filled = Insertion.into("# head\nruics: {}   # none yet\nwindows: [Keira]\n", RUIC).orElseThrow();
    assertEquals("# head\nruics:   # none yet\n  Keira:\n    type: base\nwindows: [Keira]\n", filled.whole());
    assertEquals(3, filled.line());
    assertEquals("ruics:\r\n  Keira:\r\n    type: base\r\n",
        Insertion.into("ruics: { }\r\n", RUIC).orElseThrow().whole());
  }
}
