package org.robotui.uic.log.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

class LogModelTest {
  private final Log log = new Log();

  @Test
  void entriesAreShownInTheOrderOfTheirArrival() {
    assertEquals(List.of("one", "two", "three"), log.info("one", "two", "three").messages());
  }

  @Test
  void theOldestGoWhenThereAreTooMany() {
    log.capacity = 1000;
    IntStream.range(0, 2500).forEach(i -> log.info("m" + i));
    List<String> kept = log.messages();
    assertEquals(1000, kept.size());
    assertEquals("m1500", kept.getFirst());
    assertEquals("m2499", kept.getLast());
    assertEquals(2500, log.model.current().total());
    assertEquals(1000, log.model.current().counts().get(Severity.INFO), "counts are of what is kept");
  }

  @Test
  void hugeMessagesAreCutAndDoNotFillTheMemory() {
    log.mebibytes = 4;
    String huge = "x".repeat(1_000_000);
    IntStream.range(0, 20).forEach(i -> log.info(i + huge));
    log.tick();
    Shown shown = log.model.current();
    assertEquals(7, shown.kept(), "4 MiB hold seven messages of 512 KiB");
    assertEquals(Intake.LONGEST_MESSAGE, shown.lines().getLast().last().message().length());
    assertTrue(Wording.whole(shown.lines().getLast().last()).endsWith("\n[737 858 further characters were not kept]"));
  }

  @Test
  void whatIsForgottenIsNotHeldAnyLonger() {
    Chunks<String> chunks = new Chunks<>();
    chunks.add("a");
    chunks.add("b");
    List<String> before = chunks.picture();
    chunks.removeFirst();
    assertEquals(List.of("a", "b"), before, "pictures stay as they were");
    assertEquals(List.of("b"), chunks.picture());
  }

  @Test
  void levelsAndNodesAreFiltered() {
    log.say(Severity.DEBUG, "/a", "1").say(Severity.ERROR, "/a", "2").say(Severity.ERROR, "/b", "3").tick();
    log.model.filter(LogFilter.ALL.level(Severity.DEBUG, false));
    assertEquals(List.of("2", "3"), log.messages());
    log.model.filter(LogFilter.ALL.origin("/a", false));
    assertEquals(List.of("3"), log.messages());
    log.model.filter(LogFilter.ALL.onlyOrigin("/a"));
    assertEquals(List.of("1", "2"), log.messages());
    log.model.filter(LogFilter.ALL.onlyOrigin("/a").origin("/b", true));
    assertEquals(List.of("1", "2", "3"), log.messages());
    log.model.filter(log.model.filter().cleared());
    assertEquals(3, log.messages().size());
    assertEquals(List.of(new OriginCount("/a", 2), new OriginCount("/b", 1)), log.model.current().origins());
  }

  @Test
  void aFilterSaysWhatItLeavesOut() {
    assertEquals("", LogFilter.ALL.words());
    assertEquals("level, node, search",
        LogFilter.ALL.level(Severity.INFO, false).onlyOrigin("/a").search(Search.of("x", false)).words());
    assertEquals(Set.of("/a"), LogFilter.ALL.onlyOrigin("/a").origin("/a", false).only(),
        "nothing at all is no choice");
  }

  @Test
  void whatIsAlikeInARowIsOneLineWithACount() {
    log.model.filter(LogFilter.ALL.collapse(true));
    log.info("a", "b", "b", "b", "a").tick();
    List<LogLine> lines = log.model.current().lines();
    assertEquals(List.of(1, 3, 1), lines.stream().map(LogLine::count).toList());
    log.info("a");
    List<LogLine> paused = log.model.current().lines();
    log.tick();
    assertEquals(1, paused.getLast().count(), "what was shown before does not change under the reader");
    assertEquals(2, log.model.current().lines().getLast().count());
  }

  @Test
  void aRowOfAlikesGoesWhenTheLastOfThemIsForgotten() {
    log.capacity = 2;
    log.model.filter(LogFilter.ALL.collapse(true));
    assertEquals(List.of("a"), log.info("a", "a", "a").messages());
    assertEquals(List.of("b", "c"), log.info("b", "c").messages());
  }

  @Test
  void clearingForgetsAndGoesOn() {
    log.info("one").tick();
    log.model.clear();
    assertEquals(List.of(), log.messages());
    assertTrue(log.model.current().cleared());
    assertEquals(List.of("two"), log.info("two").messages());
    assertEquals(1, log.model.current().total());
  }

  @Test
  void everyEntryIsLookedAtOnceHoweverManyCome() {
    for (int second = 0; second < 20; second++) {
      for (int i = 0; i < 5000; i++) {
        log.info("message " + i);
      }
      log.tick();
      assertEquals(0, log.model.current().left(), "a tick keeps up with 5000 entries");
    }
    assertEquals(100_000, log.model.looked());
    assertEquals(50_000, log.model.current().lines().size());
    assertFalse(log.tick(), "without news there is nothing to paint");
    assertEquals(100_000, log.model.looked());
  }

  @Test
  void aChangedFilterOverManyEntriesTakesSeveralTicksOfBoundedLength() {
    IntStream.range(0, 50_000).forEach(i -> log.info("m" + i));
    log.tick();
    long before = log.model.looked();
    log.nanosPerLook = 10_000;
    log.model.filter(LogFilter.ALL.search(Search.of("m1", false)));
    log.tick();
    assertEquals(6000, log.model.looked() - before, "60 ms at 10 microseconds an entry");
    assertEquals(44_000, log.model.current().left());
    IntStream.range(0, 8).forEach(i -> log.tick());
    assertEquals(0, log.model.current().left());
    assertEquals(11_111, log.model.current().lines().size());
  }

  @Test
  void rateAndLossesAreTold() {
    log.info("a", "b", "c", "d").tick();
    assertEquals(2, log.model.current().rateHz(), "four in two seconds");
    log.input.dropped(7);
    log.tick();
    assertEquals(7, log.model.current().dropped());
  }

  @Test
  void aRowIsFoundByItsIdAlsoWhenItIsFilteredAway() {
    log.info("a", "b", "c", "b").tick();
    log.model.filter(LogFilter.ALL.search(Search.of("b", false)));
    log.tick();
    Shown shown = log.model.current();
    assertEquals(0, shown.indexOf(1));
    assertEquals(0, shown.indexOf(2), "the one before it");
    assertEquals(1, shown.indexOf(3));
    assertEquals(-1, shown.indexOf(0));
  }

  @Test
  void entriesWithoutAStampAreDatedByOurClock() {
    log.input.put(new LogEntry(Severity.INFO, "/node", "x", ""));
    log.tick();
    assertEquals(Log.START, log.model.current().lines().getFirst().last().nanos());
  }
}
