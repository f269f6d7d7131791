package org.robotui.core.internal.life;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertEvent.Kind;
import org.robotui.api.alert.AlertId;
import org.robotui.api.alert.AlertSource;

class RuicAlertsTest {
  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");
  private static final AlertId LOW = new AlertId("sound", "Battery low");

  private final AtomicLong seconds = new AtomicLong(BEGIN.getEpochSecond());
  private final ScheduledThreadPoolExecutor timer = new ScheduledThreadPoolExecutor(1);
  @TempDir
  private Path folder;
  private RuicAlerts board;
  private AlertSource source;

  @BeforeEach
  void start() {
    board = new RuicAlerts(() -> seconds.get() * 1_000_000_000L, () -> "anna",
        new AlertStore(AlertStore.file(folder, "demo.yaml", "Keira/1"), timer));
    source = board.source("sound");
  }

  @AfterEach
  void end() {
    timer.shutdownNow();
  }

  /** As when the workbench ends and starts. */
  private void restart() {
    board.save();
    start();
  }

  @Test
  void whatHappensIsInTheHistoryWithWhoDidIt() {
    low("0.18");
    pass(20);
    low("0.17");
    board.acknowledge(LOW);
    board.acknowledge(LOW);
    pass(20);
    source.end("Battery low");
    source.end("Battery low");

    assertEquals(List.of(
        new AlertEvent(BEGIN.plusSeconds(40), LOW, Kind.ENDED, "", "", ""),
        new AlertEvent(BEGIN.plusSeconds(20), LOW, Kind.ACKNOWLEDGED, "", "", "anna"),
        new AlertEvent(BEGIN, LOW, Kind.BEGAN, "battery.charge", "0.18", "")), board.history());
  }

  @Test
  void mutesAndTheHistoryOutliveARestart() throws IOException {
    AlertId other = new AlertId("sound", "Hot");
    low("0.18");
    board.mute(LOW, Optional.of(BEGIN.plusSeconds(600)));
    board.mute(other, Optional.of(BEGIN.plusSeconds(30)));
    board.muteAll(Optional.of(Instant.MAX));
    List<AlertEvent> history = board.history();
    pass(60);
    restart();

    assertEquals(Optional.of(Instant.MAX), board.allMutedUntil());
    assertEquals(history, board.history());
    board.muteAll(Optional.empty());
    assertFalse(source.isHeard("Battery low"));
    assertTrue(source.isHeard("Hot"), "its time is over");
    assertEquals("rw-------", PosixFilePermissions
        .toString(Files.getPosixFilePermissions(AlertStore.file(folder, "demo.yaml", "Keira/1"))));
    restart();
    assertEquals(Optional.empty(), board.allMutedUntil());
    pass(600);
    assertTrue(source.isHeard("Battery low"));
  }

  @Test
  void aDamagedFileIsNoReasonToFail() throws IOException {
    low("0.18");
    restart();
    Files.writeString(AlertStore.file(folder, "demo.yaml", "Keira/1"), "history: [{time: yesterday}]");
    start();
    assertEquals(List.of(), board.history());
  }

  @Test
  void whatFluttersAndWhatIsOldDoNotFillTheHistory() {
    for (int i = 0; i < 100; i++) {
      low("0.18");
      source.end("Battery low");
      pass(1);
    }
    assertEquals(20, board.history().size());
    for (int i = 0; i < 2 * AlertHistory.MOST; i++) {
      board.mute(LOW, Optional.of(Instant.MAX));
    }
    assertEquals(AlertHistory.MOST, board.history().size());
  }

  @Test
  void anAlertIsListedWithWhatIsSeenNowAndSinceWhen() {
    low("0.18");
    pass(5);
    low("0.17");
    assertEquals(
        List.of(
            new Alert(LOW, "battery charge < 0.2", "battery.charge", "0.17", BEGIN, 1, true, false, Optional.empty())),
        board.alerts());
    assertTrue(source.isHeard("Battery low"));
  }

  @Test
  void whatIsOverStaysUntilSomebodyHasSeenIt() {
    low("0.18");
    source.end("Battery low");
    assertFalse(only().lasting());
    board.acknowledge(LOW);
    assertEquals(List.of(), board.alerts());
  }

  @Test
  void whatWasAcknowledgedIsNotHeardAndGoesWhenItIsOver() {
    low("0.18");
    board.acknowledge(LOW);
    assertTrue(only().acknowledged());
    assertFalse(source.isHeard("Battery low"));
    source.end("Battery low");
    assertEquals(List.of(), board.alerts());
    low("0.18");
    assertTrue(source.isHeard("Battery low"), "it began anew");
  }

  @Test
  void whatBeginsAgainUnseenIsCounted() {
    low("0.18");
    source.end("Battery low");
    pass(60);
    low("0.12");
    assertEquals(2, only().times());
    assertEquals(BEGIN.plusSeconds(60), only().since());
  }

  @Test
  void oneIsMutedForItsTimeAlsoWhenItBeginsAnew() {
    low("0.18");
    board.mute(LOW, Optional.of(BEGIN.plusSeconds(300)));
    source.end("Battery low");
    board.acknowledge(LOW);
    low("0.18");
    assertFalse(source.isHeard("Battery low"));
    assertTrue(source.isHeard("Scan"));
    assertEquals(Optional.of(BEGIN.plusSeconds(300)), only().mutedUntil());
    pass(300);
    assertTrue(source.isHeard("Battery low"));
    assertEquals(Optional.empty(), only().mutedUntil());
  }

  @Test
  void allAreMutedUntilSomebodySaysSo() {
    board.muteAll(Optional.of(Instant.MAX));
    low("0.18");
    pass(1_000_000);
    assertFalse(source.isHeard("Battery low"));
    board.muteAll(Optional.empty());
    assertTrue(source.isHeard("Battery low"));
    assertEquals(Optional.empty(), board.allMutedUntil());
  }

  @Test
  void whatWaitsForSomebodyStandsFirst() {
    raise("a");
    pass(1);
    raise("b");
    pass(1);
    raise("c");
    source.end("c");
    board.acknowledge(new AlertId("sound", "b"));
    assertEquals(List.of("a", "c", "b"), board.alerts().stream().map(a -> a.id().name()).toList());
  }

  @Test
  void theAlertsOfAViewEndWithIt() {
    low("0.18");
    board.forget("sound");
    assertEquals(List.of(), board.alerts());
  }

  @Test
  void noViewFillsTheMemory() {
    for (int i = 0; i < 3 * RuicAlerts.MOST; i++) {
      pass(1);
      raise("alert " + i);
      board.mute(new AlertId("sound", "alert " + i), Optional.of(Instant.MAX));
    }
    assertEquals(RuicAlerts.MOST, board.alerts().size());
    assertEquals("alert " + (3 * RuicAlerts.MOST - 1), board.alerts().getFirst().id().name(), "the newest are kept");
  }

  @Test
  void oneThatIsMutedCanBeMutedLongerHoweverManyAre() {
    low("0.18");
    board.mute(LOW, Optional.of(BEGIN.plusSeconds(60)));
    muteOthers(RuicAlerts.MOST - 1);
    board.mute(LOW, Optional.of(BEGIN.plusSeconds(600)));
    assertEquals(Optional.of(BEGIN.plusSeconds(600)), only().mutedUntil());
    assertFalse(source.isHeard("other 0"), "nothing had to go for that");
  }

  @Test
  void whatIsListedIsMutedAlsoBeyondTheMost() {
    low("0.18");
    board.mute(LOW, Optional.of(BEGIN.plusSeconds(60)));
    muteOthers(2 * RuicAlerts.MOST);
    assertFalse(source.isHeard("Battery low"), "it is listed, though it would be heard soonest");
    assertTrue(source.isHeard("other 0"), "it is not listed, and was muted first");
    assertFalse(source.isHeard("other " + (2 * RuicAlerts.MOST - 1)), "the last one is muted");
  }

  @Test
  void thatWhichWouldBeHeardSoonestMakesRoom() {
    board.mute(LOW, Optional.of(BEGIN.plusSeconds(60)));
    muteOthers(RuicAlerts.MOST);
    assertTrue(source.isHeard("Battery low"));
    assertFalse(source.isHeard("other 0"));
  }

  @Test
  void whatIsMutedNoMoreTakesNoRoom() {
    board.mute(LOW, Optional.of(BEGIN.plusSeconds(60)));
    pass(60);
    muteOthers(RuicAlerts.MOST);
    board.mute(new AlertId("sound", "other 7"), Optional.empty());
    board.mute(LOW, Optional.of(Instant.MAX));
    assertFalse(source.isHeard("Battery low"));
    assertFalse(source.isHeard("other 0"));
    assertTrue(source.isHeard("other 7"));
  }

  private void muteOthers(int count) {
    for (int i = 0; i < count; i++) {
      board.mute(new AlertId("sound", "other " + i), Optional.of(Instant.MAX));
    }
  }

  private Alert only() {
    List<Alert> all = board.alerts();
    assertEquals(1, all.size());
    return all.getFirst();
  }

  private void low(String value) {
    source.raise("Battery low", "battery charge < 0.2", "battery.charge", value);
  }

  private void raise(String name) {
    source.raise(name, "scan stale", "scan", "silent");
  }

  private void pass(long time) {
    seconds.addAndGet(time);
  }
}
