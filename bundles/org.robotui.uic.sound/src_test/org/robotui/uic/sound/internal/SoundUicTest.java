package org.robotui.uic.sound.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.Uic;
import org.robotui.api.alert.Alert;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.sensor.Battery;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.uic.sound.internal.alert.AlertScripts;
import org.robotui.uic.sound.internal.tone.Player;
import org.robotui.uic.sound.internal.tone.Tone;

class SoundUicTest {
  private static final SourceId BATTERY = new SourceId("base", "battery");
  private static final SourceId LOG = new SourceId("base", "rosout");
  private static final Instant NOW = Instant.parse("2026-11-21T12:00:00Z");

  private final FakeUicContext context = new FakeUicContext("sound", SoundType.SCHEMA);
  private final List<String> heard = new ArrayList<>();
  private final FakeInput<Data> input = context.input(SoundType.SIGNALS);

  SoundUicTest() {
    input.candidates(
        List.of(new Input.Candidate(BATTERY, "Battery"), new Input.Candidate(new SourceId("base", "scan"), "LaserScan"),
            new Input.Candidate(LOG, "LogEntry")));
  }

  @Test
  void onlyWhatAlertsNeedIsAskedOfTheRobot() {
    uic(Map.of("when", "battery charge < 0.2")).tick(0);
    assertEquals(Set.of(BATTERY), input.chosen());
  }

  @Test
  void aLowBatteryIsHeardAtItsVolume() {
    context.settings().set(SoundType.VOLUME, 0.5);
    SoundUic uic = uic(Map.of("when", "battery charge < 0.2", "sound", "alarm", "volume", 0.8));
    charge(0.5);
    uic.tick(0);
    assertTrue(heard.isEmpty());
    charge(0.1);
    assertFalse(uic.tick(1), "there is nothing to show");
    assertEquals(List.of(Tone.ALARM.sound().samples().length + " at 0.4"), heard);
  }

  @Test
  void anAlertIsSpokenBehindTheNameOfTheRobotWhereThatIsWanted() {
    SoundUic uic = uic(Map.of("when", "battery charge < 0.2 and battery charge > 0.1", "speech", true, "name", "Low"),
        Map.of("when", "battery charge < 0.2 or link lost", "speech", true, "words", "go home"));
    charge(0.15);
    uic.tick(0);
    String robot = context.ruic().name();
    String beep = Tone.BEEP.sound().samples().length + " at 1.0";
    assertEquals(List.of(beep, robot + ": Low", beep, robot + ": go home"), heard);
  }

  @Test
  void mutedAlertsAreNotHeardButGoOn() {
    SoundUic uic = uic(Map.of("when", "battery charge < 0.2", "repeat", 1.0));
    context.settings().set(SoundType.MUTED, true);
    charge(0.1);
    uic.tick(0);
    assertTrue(heard.isEmpty());
    context.settings().set(SoundType.MUTED, false);
    uic.tick(2_000_000_000L);
    assertEquals(1, heard.size());
  }

  @Test
  void oneAlertMayBeMutedAlone() {
    SoundUic uic = uic(Map.of("when", "battery charge < 0.2", "muted", true), Map.of("when", "battery charge < 0.3"));
    charge(0.1);
    uic.tick(0);
    assertEquals(1, heard.size());
  }

  @Test
  void alertsAreMutedUntilATime() {
    context.settings().set(SoundType.MUTED_UNTIL, "2026-11-21T12:00:01Z");
    assertEquals(Optional.of(NOW.plusSeconds(1)), Mute.until(context.settings().current()));
    context.settings().set(SoundType.MUTED_UNTIL,
        LocalDateTime.ofInstant(NOW, ZoneId.systemDefault()).plusMinutes(1).toString());
    assertEquals(Optional.of(NOW.plusSeconds(60)), Mute.until(context.settings().current()));
  }

  @Test
  void anAlertIsListedWhileItLastsAndAfter() {
    SoundUic uic = uic(Map.of("name", "Battery low", "when", "battery charge < 0.2"));
    charge(0.1);
    uic.tick(0);
    charge(0.05);
    uic.tick(1);
    Alert alert = context.alerts().find("Battery low").orElseThrow();
    assertEquals(List.of("battery charge < 0.2", "battery.charge", "0.05"),
        List.of(alert.condition(), alert.source(), alert.value()));
    assertTrue(alert.lasting());
    charge(0.5);
    uic.tick(2);
    assertFalse(context.alerts().find("Battery low").orElseThrow().lasting());
  }

  @Test
  void anEntryOfALogIsListedButDoesNotLast() {
    SoundUic uic = uic(Map.of("when", "log >= ERROR"));
    input.put(LOG, new LogEntry(Severity.ERROR, "/planner", "no path", ""), 0, Optional.empty());
    uic.tick(0);
    Alert alert = context.alerts().find("log >= ERROR").orElseThrow();
    assertEquals("/planner", alert.source());
    assertEquals("ERROR: no path", alert.value());
    assertFalse(alert.lasting());
  }

  @Test
  void whatWasAcknowledgedOrMutedByHandIsNotHeard() {
    SoundUic uic = uic(Map.of("name", "low", "when", "battery charge < 0.2", "repeat", 1.0));
    charge(0.1);
    uic.tick(0);
    context.alerts().acknowledge(context.alerts().find("low").orElseThrow().id());
    uic.tick(2_000_000_000L);
    assertEquals(1, heard.size());
  }

  @Test
  void theSettingsMuteOnceSoThatAHandCanUnmute() {
    SoundUic uic = uic(Map.of("when", "battery charge < 0.2", "repeat", 1.0));
    context.settings().set(SoundType.MUTED, true);
    charge(0.1);
    uic.tick(0);
    assertEquals(Optional.of(Instant.MAX), context.alerts().allMutedUntil());
    context.alerts().muteAll(Optional.empty());
    uic.tick(2_000_000_000L);
    assertEquals(1, heard.size());
  }

  @Test
  void alertsOfOneNameAreToldApart() {
    List<String> names = uic(Map.of("when", "link lost"), Map.of("when", "link lost")).alerts().stream()
        .map(a -> a.config().name()).toList();
    assertEquals(List.of("link lost", "link lost (2)"), names);
  }

  @Test
  void aTimeThatCannotBeReadMutesNothing() {
    SoundUic uic = uic(Map.of("when", "battery charge < 0.2"));
    context.settings().set(SoundType.MUTED_UNTIL, "tomorrow");
    charge(0.1);
    uic.tick(0);
    assertEquals(1, heard.size());
  }

  @Test
  void logEntriesAreHeardOnce() {
    SoundUic uic = uic(Map.of("when", "log >= ERROR"));
    uic.tick(0);
    input.put(LOG, new LogEntry(Severity.ERROR, "/planner", "no path", ""), 0, Optional.empty());
    uic.tick(2_000_000_000L);
    uic.tick(4_000_000_000L);
    assertEquals(1, heard.size());
  }

  @Test
  void aSourceThatGoesIsHeard() {
    SoundUic uic = uic(Map.of("when", "battery stale", "sound", "chime"));
    charge(0.5);
    uic.tick(0);
    input.state(BATTERY, new InputState.Stale(2, "the link is lost"));
    uic.tick(1);
    assertEquals(1, heard.size());
  }

  @Test
  void mistakesNameTheAlertTheMistakeAndTheRemedy() {
    assertMistake(Map.of("name", "Battery", "when", "battery charge < low"),
        "alert 1 (Battery): 'low' is no number; after < write one, or compare by == or !=");
    assertMistake(Map.of("when", "link lost", "sound", "ping"),
        "alert 1 (link lost): there is no sound 'ping'; write one of beep, chime, alarm, or the path of a .wav file");
    assertMistake(Map.of("when", "log >= ERROR", "for", 2.0),
        "alert 1 (log >= ERROR): what is over as soon as it happens does not last; leave out 'for'");
    assertMistake(Map.of("when", "link lost for 2 s", "for", 2.0),
        "alert 1 (link lost for 2 s): 'for' is said twice; leave it out of 'when', or here");
    Exception e = assertThrows(IllegalArgumentException.class, () -> Mute.time("6 pm"));
    assertEquals("muted_until: '6 pm' is no time; write for example 2026-11-21T18:00, or with Z for UTC",
        e.getMessage());
  }

  @Test
  void theTypeMakesAnInstanceThatLeavesNothingBehind() {
    SoundType type = new SoundType();
    try (Uic uic = type.create(context, settings(List.of()))) {
      assertFalse(uic.tick(0));
    }
  }

  private static void assertMistake(Map<String, Object> alert, String message) {
    Settings settings = settings(List.of(alert(alert)));
    Exception e = assertThrows(IllegalArgumentException.class, () -> AlertReader.read(settings));
    assertEquals(message, e.getMessage());
  }

  private void charge(double charge) {
    input.put(BATTERY, new Battery(12, -1, charge, Battery.Status.DISCHARGING), 0, Optional.empty());
  }

  @SafeVarargs
  private SoundUic uic(Map<String, Object>... alerts) {
    Settings settings = settings(List.of(alerts).stream().map(SoundUicTest::alert).toList());
    Player player =
        new Player(Runnable::run, () -> (sound, volume) -> heard.add(sound.samples().length + " at " + volume),
            heard::add, () -> heard.add("bell"), heard::add);
    return new SoundUic(context, AlertReader.read(settings), player,
        new AlertScripts(context.ruic().name(), Optional::empty, Runnable::run, context::alert));
  }

  private static Settings settings(List<Settings> alerts) {
    return filled(SoundType.SCHEMA, Map.of(SoundType.ALERTS, alerts));
  }

  private static Settings alert(Map<String, Object> values) {
    return filled(SoundType.ALERT, values);
  }

  private static Settings filled(Schema schema, Map<String, Object> values) {
    Map<String, Object> all = new HashMap<>(values);
    all.computeIfPresent(SoundType.SOUND, (name, sound) -> Placed.nowhere(sound));
    schema.settings().forEach(setting -> setting.fallback().ifPresent(value -> all.putIfAbsent(setting.name(), value)));
    return new Settings(schema, all);
  }
}
