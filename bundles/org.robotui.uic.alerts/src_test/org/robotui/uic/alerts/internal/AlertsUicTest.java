package org.robotui.uic.alerts.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertWords;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;

class AlertsUicTest {
  private static final Instant NOW = Instant.parse("2026-11-21T12:00:00Z");

  private final FakeUicContext context = new FakeUicContext("alerts", AlertsType.SCHEMA);
  private final AlertsUic uic = new AlertsUic(context, Clock.fixed(NOW, ZoneOffset.UTC));

  @Test
  void aTickTellsOnlyNews() {
    assertFalse(uic.tick(0));
    context.alerts().raise("Battery low", "battery charge < 0.2", "battery.charge", "0.18");
    assertTrue(uic.tick(1));
    assertFalse(uic.tick(2));
    assertEquals("1 new of 1", uic.page().note());
  }

  @Test
  void whatIsAcknowledgedWaitsForNobody() {
    Alert alert = raised();
    assertEquals(Health.BAD, AlertColumns.health(alert));
    uic.acknowledge(uic.page().alerts());
    assertEquals(0, uic.page().waiting());
    assertEquals(Health.WARNING, AlertColumns.health(uic.page().alerts().getFirst()));
  }

  @Test
  void oneIsMutedForSomeMinutesOrWithoutEnd() {
    raised();
    uic.mute(uic.page().alerts(), Optional.of(10L));
    assertEquals(Optional.of(NOW.plusSeconds(600)), uic.page().alerts().getFirst().mutedUntil());
    uic.mute(uic.page().alerts(), Optional.empty());
    assertEquals(Optional.of(Instant.MAX), uic.page().alerts().getFirst().mutedUntil());
    uic.mute(uic.page().alerts(), Optional.of(0L));
    assertEquals(Optional.empty(), uic.page().alerts().getFirst().mutedUntil());
  }

  @Test
  void allAreMuted() {
    uic.muteAll(Optional.of(60L));
    assertEquals(Optional.of(NOW.plusSeconds(3600)), uic.page().mutedUntil());
    uic.muteAll(Optional.of(0L));
    assertEquals(Optional.empty(), uic.page().mutedUntil());
  }

  @Test
  void theWordsSayWhatIsSo() {
    AlertWords words = new AlertWords(ZoneOffset.UTC);
    Alert alert = raised();
    assertEquals("on", words.state(alert));
    assertEquals("00:00:00", words.since(alert));
    context.alerts().mute(alert.id(), Optional.of(Instant.MAX));
    context.alerts().acknowledge(alert.id());
    assertEquals("acknowledged, muted", words.state(context.alerts().find("Battery low").orElseThrow()));
    context.alerts().end("Battery low");
    assertEquals("over, muted", words.state(context.alerts().find("Battery low").orElseThrow()));
    assertEquals("muted until 12:10", words.muted(Instant.parse("2001-01-01T12:10:00Z")));
    assertEquals("muted until 2999-01-01 08:00", words.muted(Instant.parse("2999-01-01T08:00:00Z")));
  }

  private Alert raised() {
    context.alerts().raise("Battery low", "battery charge < 0.2", "battery.charge", "0.18");
    uic.tick(0);
    return uic.page().alerts().getFirst();
  }
}
