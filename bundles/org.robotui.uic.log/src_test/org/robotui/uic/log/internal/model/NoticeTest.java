package org.robotui.uic.log.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.data.status.Severity;

class NoticeTest {
  private static final InputState LIVE = new InputState.Live(1, 0);

  private final Log log = new Log();

  private Optional<String> inPlace(InputState state) {
    return Notice.inPlace(log.model.current(), state).map(Notice::title);
  }

  @Test
  void anEmptyListSaysWhy() {
    assertEquals(Optional.empty(), inPlace(new InputState.Unconnected("nothing fits")), "the state says it");
    assertEquals(Optional.of("No log entries yet"), inPlace(LIVE));
    log.info("one").tick();
    assertEquals(Optional.empty(), inPlace(LIVE));
    log.model.filter(LogFilter.ALL.level(Severity.INFO, false));
    log.tick();
    assertEquals("1 entries are hidden by level. \u201cShow all\u201d brings them back.",
        Notice.inPlace(log.model.current(), LIVE).orElseThrow().sentence());
    log.model.clear();
    log.tick();
    assertEquals(Optional.of("Cleared"), inPlace(LIVE));
  }

  @Test
  void entriesStayWhenTheLinkIsLostAndItIsToldAboveThem() {
    log.info("one").tick();
    Notice lost = Notice.above(log.model.current(), new InputState.Stale(12, "the link is lost")).orElseThrow();
    assertEquals("stale 12\u00a0s: the link is lost", lost.title() + ": " + lost.sentence());
    assertEquals("not connected",
        Notice.above(log.model.current(), new InputState.Unconnected("gone")).orElseThrow().title());
    assertEquals(Optional.empty(), Notice.above(log.model.current(), LIVE));
  }

  @Test
  void aBadExpressionIsToldAbove() {
    log.model.filter(LogFilter.ALL.search(Search.of("(", true)));
    log.info("one").tick();
    assertEquals("unclosed group at character 1", Notice.above(log.model.current(), LIVE).orElseThrow().sentence());
  }

  @Test
  void theTitleCountsAndTellsRateAndLosses() {
    log.info("one", "two").say(Severity.ERROR, "/a", "x").tick();
    assertEquals("3  1.5\u00a0/s", Notice.title(log.model.current()));
    log.model.filter(LogFilter.ALL.level(Severity.INFO, false));
    log.input.dropped(1200);
    log.tick();
    assertEquals("1 of 3  1.5\u00a0/s  1\u00a0200 lost", Notice.title(log.model.current()));
  }
}
