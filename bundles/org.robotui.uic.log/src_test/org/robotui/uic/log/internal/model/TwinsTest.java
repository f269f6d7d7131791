package org.robotui.uic.log.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Envelope;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

class TwinsTest {
  private static final LogEntry HOT = new LogEntry(Severity.WARNING, "/motor", "hot", "motor.cpp:3");

  private final Log log = new Log();

  @Test
  void anEntryThatComesOnTwoPortsIsShownOnce() {
    log.say(Log.DIRECT, 1, HOT).say(Log.REPEATED, 1.1, HOT);
    assertEquals(List.of("hot"), log.messages());
  }

  @Test
  void itDoesNotMatterWhichPortIsFirst() {
    log.say(Log.REPEATED, 1, HOT).say(Log.DIRECT, 2.9, HOT);
    assertEquals(List.of("hot"), log.messages());
  }

  @Test
  void whatANodeSaysTwiceIsShownTwiceAlsoWhenBothAreRepeated() {
    log.say(Log.DIRECT, 1, HOT).say(Log.DIRECT, 1, HOT).say(Log.REPEATED, 1, HOT).say(Log.REPEATED, 1, HOT);
    assertEquals(List.of("hot", "hot"), log.messages());
  }

  @Test
  void theSameLaterOrOfAnotherIsNoTwin() {
    log.say(Log.DIRECT, 1, HOT).say(Log.REPEATED, 3.5, HOT)
        .say(Log.REPEATED, 3.5, new LogEntry(Severity.WARNING, "/arm", "hot", ""));
    assertEquals(List.of("hot", "hot", "hot"), log.messages());
  }

  @Test
  void sourcesMayBeDrainedOneAfterTheOther() {
    for (int i = 0; i < 10; i++) {
      log.say(Log.DIRECT, i, new LogEntry(Severity.INFO, "/motor", "m" + i, ""));
    }
    for (int i = 0; i < 10; i++) {
      log.say(Log.REPEATED, i + 0.1, new LogEntry(Severity.INFO, "/motor", "m" + i, ""));
    }
    assertEquals(10, log.messages().size(), "also after the view has not looked for ten seconds");
  }

  @Test
  void whatIsTooOldToHaveTwinsIsForgotten() {
    Twins twins = new Twins();
    twins.isTwin(new Envelope<>(HOT, Log.DIRECT, 0, Optional.empty(), 0, Optional.empty()), "/motor");
    twins.isTwin(new Envelope<>(HOT, Log.DIRECT, 0, Optional.of(new Stamp(1, ClockKind.ROBOT)), 3 * Log.SECOND,
        Optional.empty()), "/motor");
    twins.settle();
    assertEquals(1, twins.size());
  }

  @Test
  void anotherStampIsAnotherEntry() {
    Twins twins = new Twins();
    assertEquals(List.of(false, false), List.of(
        twins.isTwin(envelope(0), "/motor"),
        twins.isTwin(
            new Envelope<>(HOT, Log.REPEATED, 1, Optional.of(new Stamp(1, ClockKind.ROBOT)), 0, Optional.empty()),
            "/motor")));
  }

  @Test
  void itsMemoryIsBounded() {
    Twins twins = new Twins();
    for (int i = 0; i < 3 * Twins.MOST; i++) {
      twins.isTwin(envelope(i), "/motor");
    }
    assertTrue(twins.size() <= Twins.MOST + 1, () -> twins.size() + " held");
  }

  private static Envelope<LogEntry> envelope(long stamp) {
    return new Envelope<>(HOT, Log.DIRECT, stamp, Optional.of(new Stamp(stamp, ClockKind.ROBOT)), 0, Optional.empty());
  }
}
