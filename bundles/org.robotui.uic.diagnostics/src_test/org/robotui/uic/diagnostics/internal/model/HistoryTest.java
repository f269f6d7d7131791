package org.robotui.uic.diagnostics.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.uic.diagnostics.internal.model.Bench.error;
import static org.robotui.uic.diagnostics.internal.model.Bench.item;
import static org.robotui.uic.diagnostics.internal.model.Bench.ok;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongUnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.data.status.Diagnostics;

class HistoryTest {
  private static final String MOTOR = "base./diagnostics/Robot/Motor";

  private final Bench bench = new Bench();

  @Test
  void eachLineAndTheWholeHaveAStripOfTheWorstOfEachSlot() {
    bench.say(10, ok("/Robot/Motor"));
    bench.at(10.1);
    bench.say(11, error("/Robot/Motor"));
    bench.at(11.1);
    bench.say(11.5, ok("/Robot/Motor"));
    Shown shown = bench.at(11.6);
    for (Strip strip : List.of(shown.rows().getFirst().strip(), shown.rows().getLast().strip(), shown.overall())) {
      assertEquals(Level.ERROR, strip.level(strip.index(11)));
      assertEquals(Level.OK, strip.level(strip.index(10)));
      assertEquals(Level.UNKNOWN, strip.level(strip.index(9)));
      assertEquals(11, strip.slot(strip.size() - 1));
    }
  }

  @Test
  void whatWasNotLookedAtIsUnknownInTheStrip() {
    bench.say(10, ok("motor"));
    bench.at(10.1);
    Strip strip = bench.at(14.5).overall();
    assertEquals(Level.OK, strip.level(strip.index(14)));
    assertEquals(Level.UNKNOWN, strip.level(strip.index(12)));
  }

  @Test
  void aMomentShowsLevelsMessageAndValuesOfThatTime() {
    bench.say(10, item("/Robot/Motor", Diagnostics.Level.OK, "fine", "Temperature", "40 C"));
    bench.at(10.1);
    bench.say(20, item("/Robot/Motor", Diagnostics.Level.ERROR, "hot", "Temperature", "99 C"));
    bench.at(20.1);
    bench.say(30, item("/Robot/Motor", Diagnostics.Level.OK, "fine", "Temperature", "50 C"));
    bench.at(30.1);
    bench.model.ask(Ask.DEFAULT.select(Optional.of(MOTOR)).at(Optional.of(20L)));
    Shown then = bench.at(30.2);
    assertEquals("hot", then.detail().orElseThrow().message());
    assertEquals(List.of(new DiagnosticsDetail.Value("Temperature", "99 C")), then.detail().orElseThrow().values());
    assertEquals(Level.ERROR, then.rows().getFirst().level());
    assertEquals(Level.ERROR, then.level());
    assertEquals(Map.of(Level.ERROR, 1), then.counts());
    assertEquals(9.2, then.secondsAgo(20), 1e-6);
    bench.model.ask(bench.model.ask().at(Optional.empty()));
    assertEquals(Level.OK, bench.at(30.3).level());
  }

  @Test
  void beforeTheFirstReportNothingIsKnown() {
    bench.say(10, ok("/Robot/Motor"));
    bench.at(10.1);
    bench.model.ask(Ask.DEFAULT.select(Optional.of(MOTOR)).at(Optional.of(5L)));
    assertEquals(Level.UNKNOWN, bench.at(10.2).level());
    assertEquals("no longer kept", bench.at(10.2).detail().orElseThrow().told());
  }

  @Test
  void aMomentThatIsTooOldGivesWayToNow() {
    bench.say(10, ok("motor"));
    bench.model.ask(Ask.DEFAULT.at(Optional.of(10L)));
    assertEquals(Optional.of(10L), bench.at(10.5).ask().slot());
    assertEquals(Optional.empty(), bench.at(11 + DiagnosticsModel.SLOTS).ask().slot());
  }

  @Test
  void ofAFlickerWithinASlotTheWorstIsRemembered() {
    Part part = new Part("motor");
    History history = new History(1 << 20);
    history.note(part, ok("motor"), 0);
    history.note(part, error("motor"), 10);
    history.note(part, ok("motor"), 20);
    assertEquals(Level.ERROR, part.at(5, 100).orElseThrow().level());
    assertEquals(Level.OK, part.at(20, 100).orElseThrow().level());
  }

  @Test
  void theMemoryOfTheHistoryIsBoundedAndTheNewestStays() {
    DiagnosticsModel model = new DiagnosticsModel(bench.input, 4, LongUnaryOperator.identity(), 100_000);
    IntStream.range(0, 2000).forEach(second -> {
      bench.say(second,
          item("/Robot/Motor", Diagnostics.Level.OK, "message " + second, "Text", "x".repeat(500) + second),
          ok("/Robot/Still"));
      model.tick(second * Bench.SECOND, Bench.STALE);
    });
    assertTrue(model.historyBytes() <= 100_000, () -> model.historyBytes() + " bytes");
    assertEquals(List.of("2 parts", "message 1999", "fine"),
        model.current().rows().stream().map(DiagnosticsRow::message).toList());
  }

  @Test
  void textsThatDoNotChangeAreKeptOnce() {
    Part part = new Part("motor");
    History history = new History(1 << 20);
    history.note(part, item("motor", Diagnostics.Level.OK, "fine", "Serial", "x".repeat(1000), "Temperature", "40"), 0);
    long first = history.bytes();
    history.note(part, item("motor", Diagnostics.Level.OK, "fine", "Serial", "x".repeat(1000), "Temperature", "41"),
        Bench.SECOND);
    assertTrue(history.bytes() - first < 500, () -> history.bytes() - first + " bytes more");
    history.note(part, item("motor", Diagnostics.Level.OK, "fine", "Serial", "x".repeat(1000), "Temperature", "41"),
        2 * Bench.SECOND);
    assertEquals(Map.of("Serial", "x".repeat(1000), "Temperature", "41"), part.newest().orElseThrow().details());
  }

  @Test
  void aFastReporterIsNotedFourTimesASecond() {
    Part part = new Part("motor");
    History history = new History(1 << 20);
    for (int i = 0; i < 1000; i++) {
      history.note(part, item("motor", Diagnostics.Level.OK, "message " + i), i * 1_000_000L);
    }
    assertEquals("message 999", part.newest().orElseThrow().message());
    long kept = IntStream.range(0, 1000).mapToObj(i -> part.at(i * 1_000_000L, i * 1_000_000L).orElseThrow().message())
        .distinct().count();
    assertEquals(4, kept);
  }
}
