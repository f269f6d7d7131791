package org.robotui.uic.diagnostics.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.uic.diagnostics.internal.model.Bench.error;
import static org.robotui.uic.diagnostics.internal.model.Bench.item;
import static org.robotui.uic.diagnostics.internal.model.Bench.ok;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.data.status.Diagnostics;

class TreeTest {
  private final Bench bench = new Bench();

  @Test
  void namesMakeATreeAndTheWorstRises() {
    bench.say(1, ok("/Robot/Base/Motor 10"), error("/Robot/Base/Motor 2"), ok("/Robot/Camera"));
    bench.model.ask(Ask.DEFAULT.open("base./diagnostics/Robot/Base", true));
    assertEquals(List.of("Robot Error", "  Base Error", "    Motor 2 Error", "    Motor 10 OK", "  Camera OK"),
        bench.lines(1.1));
    assertEquals("1 of 2 not OK", bench.row(1.1, "Base").message());
  }

  @Test
  void theTopIsOpenUntilItIsClosedAndTheRestClosedUntilItIsOpened() {
    bench.say(1, ok("/Robot/Base/Motor"));
    assertEquals(List.of("Robot OK", "  Base OK"), bench.lines(1.1));
    bench.model.ask(Ask.DEFAULT.open("base./diagnostics/Robot", false));
    assertEquals(List.of("Robot OK"), bench.lines(1.2));
  }

  @Test
  void aGroupMayReportItself() {
    bench.say(1, item("/Robot", Diagnostics.Level.WARNING, "warm"), ok("/Robot/Base"));
    assertEquals(List.of("Robot Warning", "  Base OK"), bench.lines(1.1));
    assertEquals("warm", bench.row(1.1, "Robot").message());
    assertEquals(Map.of(Level.OK, 1), bench.at(1.1).counts(), "groups are not counted");
  }

  @Test
  void whatDoesNotReportIsStaleAndSaysForHowLong() {
    bench.say(1, ok("motor")).say(4, error("camera"));
    assertEquals(List.of("camera Error", "motor OK"), bench.lines(6));
    assertEquals(List.of("camera Error", "motor Stale"), bench.lines(6.1));
    assertEquals("no report for 6.0\u00a0s, the last was: fine", bench.row(7, "motor").message());
    bench.say(8, ok("motor"));
    assertEquals("motor OK", bench.lines(8.1).getLast());
  }

  @Test
  void staleIsWorseThanAWarningAndBetterThanAnError() {
    assertEquals(Level.STALE, Level.WARNING.worse(Level.STALE));
    assertEquals(Level.ERROR, Level.STALE.worse(Level.ERROR));
  }

  @Test
  void onlyProblemsAndWhatLeadsToThemAreShown() {
    bench.say(1, ok("/Robot/Base/Motor 1"), error("/Robot/Base/Motor 2"), ok("/Robot/Camera"));
    bench.model.ask(Ask.DEFAULT.problems(true));
    assertEquals(List.of("Robot Error", "  Base Error", "    Motor 2 Error"), bench.lines(1.1));
  }

  @Test
  void theSearchFindsNamesMessagesAndValues() {
    bench.say(1, item("/Robot/Base/Motor", Diagnostics.Level.OK, "fine", "Temperature", "52 C"),
        ok("/Robot/Camera/Left"));
    bench.model.ask(Ask.DEFAULT.search("temp 52"));
    assertEquals(List.of("Robot OK", "  Base OK", "    Motor OK"), bench.lines(1.1));
    bench.model.ask(Ask.DEFAULT.search("camera"));
    assertEquals(List.of("Robot OK", "  Camera OK", "    Left OK"), bench.lines(1.2));
    bench.model.ask(Ask.DEFAULT.search("camera").problems(true));
    assertEquals(List.of(), bench.lines(1.3));
  }

  @Test
  void twoSourcesAreToldApart() {
    bench.say(Bench.RAW, 1, ok("motor")).say(new org.robotui.api.port.SourceId("arm", "/diagnostics"), 1,
        error("motor"));
    assertEquals(List.of("/diagnostics OK", "  motor OK", "/diagnostics Error", "  motor Error"), bench.lines(1.1));
    bench.model.ask(Ask.DEFAULT.source("arm./diagnostics"));
    assertEquals(List.of("motor Error"), bench.lines(1.2));
  }

  @Test
  void whoSortsTheReportsOfOthersIsShownAloneAsLongAsHeLives() {
    bench.say(Bench.RAW, 1, ok("driver: motor")).say(Bench.SORTED, 1, ok("/Robot/driver: motor"));
    assertEquals(List.of("Robot OK", "  driver: motor OK"), bench.lines(1.1));
    bench.say(Bench.RAW, 7, error("driver: motor"));
    assertEquals(List.of("/diagnostics Error", "  driver: motor Error", "/diagnostics_agg Stale", "  Robot Stale"),
        bench.lines(7.1));
    bench.model.ask(Ask.DEFAULT.source(Ask.ALL_SOURCES));
    bench.say(Bench.SORTED, 7.2, ok("/Robot/driver: motor"));
    assertEquals(4, bench.lines(7.3).size());
  }

  @Test
  void silentPartsAreForgottenOnRequest() {
    bench.say(1, ok("/a/old"), ok("/a/new")).say(9, ok("/a/new"));
    assertEquals(3, bench.lines(9.1).size());
    bench.model.forgetSilent();
    assertEquals(List.of("a OK", "  new OK"), bench.lines(9.2));
    bench.say(10, ok("/a/old"));
    assertEquals(3, bench.lines(10.1).size(), "and come back when they report again");
  }

  @Test
  void hostileNamesAreBounded() {
    bench.say(1,
        IntStream.range(0, Forest.MOST_PARTS + 10).mapToObj(i -> ok("part " + i)).toArray(Diagnostics.Item[]::new));
    bench.say(1, ok("/".repeat(10)), ok(""), ok("a/".repeat(1000)));
    Shown shown = bench.at(1.1);
    assertEquals(Forest.MOST_PARTS, shown.parts());
    assertEquals(13, shown.refused());
    assertEquals(12, Forest.path("a/".repeat(100)).size());
    assertEquals(List.of("(no name)"), Forest.path(""));
  }

  @Test
  void namesThatMeanTheSamePlaceKeepALineEach() {
    bench.say(1, ok("a/b"), error("/a/b"));
    bench.model.ask(Ask.DEFAULT.open("base./diagnostics/a/b", true));
    assertEquals(List.of("a Error", "  b Error", "    /a/b Error"), bench.lines(1.1));
  }

  @Test
  void theDetailsAreThoseOfTheSelectedLine() {
    bench.say(1, new Diagnostics.Item("/Robot/Motor", "maxon-7", Diagnostics.Level.WARNING, "warm",
        Map.of("Temperature", "71 C")));
    bench.model.ask(Ask.DEFAULT.select(Optional.of("base./diagnostics/Robot/Motor")));
    DiagnosticsDetail detail = bench.at(3).detail().orElseThrow();
    assertEquals("/Robot/Motor  Warning  warm\nhardware: maxon-7\nTemperature: 71 C\n", detail.text());
    assertEquals("reported 2.0\u00a0s ago", detail.told());
    bench.model.ask(Ask.DEFAULT.select(Optional.of("base./diagnostics/Robot")));
    assertEquals(List.of(new DiagnosticsDetail.Value("Motor", "Warning: warm")),
        bench.at(3.1).detail().orElseThrow().values());
  }

  @Test
  void withoutNewsThereIsSomethingToPaintOnceASecondForTheAges() {
    bench.say(1, ok("motor"));
    assertTrue(bench.model.tick(Bench.SECOND, Bench.STALE));
    assertEquals(false, bench.model.tick(Bench.SECOND + 1, Bench.STALE));
    assertTrue(bench.model.tick(2 * Bench.SECOND, Bench.STALE));
  }

  @Test
  void whileARecordingStandsNothingFallsSilent() {
    bench.aging = nanos -> Math.min(nanos, 2 * Bench.SECOND);
    bench.say(1, ok("motor"));
    assertEquals(List.of("motor OK"), bench.lines(1));
    assertEquals(List.of("motor OK"), bench.lines(60));
    bench.aging = nanos -> Math.min(nanos, 2 * Bench.SECOND) + 10 * Math.max(0, nanos - 60 * Bench.SECOND);
    assertEquals(List.of("motor Stale"), bench.lines(61), "it was played ten times as fast");
  }
}
