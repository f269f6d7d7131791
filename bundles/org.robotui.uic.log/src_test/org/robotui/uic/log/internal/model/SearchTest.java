package org.robotui.uic.log.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.status.Severity;

class SearchTest {
  private static Entry entry(String message) {
    return new Entry(0, Severity.INFO, "/move_base", message, "planner.cpp:120", 0, 0);
  }

  @Test
  void wordsAreFoundInMessageNodeAndPlaceWhateverTheirCapitals() {
    assertTrue(Search.of("GOAL", false).accepts(entry("new goal")));
    assertTrue(Search.of("move_", false).accepts(entry("")));
    assertTrue(Search.of("planner.cpp", false).accepts(entry("")));
    assertFalse(Search.of("new.goal", false).accepts(entry("new goal")), "words are no expression");
  }

  @Test
  void expressionsAreFoundAndShowWhere() {
    Search search = Search.of("\\d+ m", true);
    assertTrue(search.accepts(entry("gone 12 m of 20 m")));
    assertEquals(List.of(new Search.Span(5, 9), new Search.Span(13, 17)), search.spans("gone 12 m of 20 m"));
    assertEquals(List.of(), Search.of("x*", true).spans("abc"), "nothing is no match to show");
  }

  @Test
  void aBadExpressionSaysWhatIsWrongAndShowsAll() {
    Search search = Search.of("go(al", true);
    assertEquals("unclosed group at character 5", search.problem());
    assertTrue(search.accepts(entry("anything")));
    assertEquals(List.of(), search.spans("anything"));
  }

  @Test
  void aCatastrophicExpressionEndsAndSaysSo() {
    Search search = Search.of("(a+)+\\1c", true);
    assertTrue(search.active());
    assertTrue(search.accepts(entry("a".repeat(40) + "b")), "what cannot be decided is shown");
    assertFalse(search.active());
    assertEquals("this expression takes too long on some entries; nothing is left out", search.problem());
  }

  @Test
  void aTextOfManyStepsIsNotReadLongerThanAllowed() {
    Metered text = new Metered("a".repeat(100), 10);
    int reads = 0;
    try {
      while (true) {
        text.subSequence(0, 100).charAt(reads);
        reads++;
      }
    } catch (TooSlowException e) {
      assertEquals(10, reads);
    }
  }

  @Test
  void anExpressionThatRecursesTooDeeplyIsNoCrash() {
    Search search = Search.of("(a|b)*c", true);
    assertTrue(search.accepts(entry("ab".repeat(100_000))));
    assertFalse(search.problem().isEmpty());
  }

  @Test
  void aSearchThatGivesUpShowsAllThatItHadLeftOut() {
    Log log = new Log();
    log.info("first", "a".repeat(40) + "b", "last").tick();
    log.model.filter(LogFilter.ALL.search(Search.of("(a+)+\\1c", true)));
    log.tick();
    assertEquals(3, log.messages().size());
    assertFalse(log.model.filter().search().active());
  }
}
