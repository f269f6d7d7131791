package org.robotui.condition;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.Severity;

class ConditionsTest {
  private final FakeSignals signals = new FakeSignals();

  @ParameterizedTest
  @ValueSource(strings = {"battery charge < 0.2", "battery: charge < 0.2", "/battery charge<0.2",
      "base.battery charge <= 0.19",
      "battery status == discharging", "battery status != 'full'", "battery voltage >= 12",
      "base./battery current > -2"})
  void theseHoldForALowBattery(String text) {
    assertInstanceOf(Verdict.Holds.class, check(text, signals.battery(0.19)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"battery charge < 0.1", "battery charge == 0.2", "battery status == charging",
      "battery voltage > 12"})
  void theseDoNot(String text) {
    assertInstanceOf(Verdict.Fails.class, check(text, signals.battery(0.19)));
  }

  @Test
  void aVerdictSaysWhatWasSeen() {
    assertSeen("battery.charge is 0.19", check("battery charge < 0.2", signals.battery(0.19)));
  }

  @Test
  void valuesThatAreNotKnownHoldNothing() {
    assertInstanceOf(Verdict.Fails.class, check("battery charge < 0.2", signals.battery(Double.NaN)));
    signals.battery(0.1).state("battery", new InputState.Stale(3, "link lost"));
    assertEquals(new Verdict.Unknown("battery sends nothing now", false), check("battery charge < 0.2", signals));
    assertEquals(new Verdict.Unknown("nothing called 'bumper' is offered", false),
        check("bumper pressed == true", signals));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
      "battery charg < 0.2 | battery (Battery) has no field 'charg'; it has voltage, current, charge, status",
      "battery status < 3 | battery.status is 'DISCHARGING', which is no number; compare it by == or !=",
      "battery charge == low | battery.charge is a number and cannot be compared with 'low'"})
  void whatCanNeverHoldIsSaid(String text, String reason) {
    assertEquals(new Verdict.Unknown(reason, true), check(text, signals.battery(0.1)));
  }

  @Test
  void fieldsAreFoundByTheNamesOfTheRobot() {
    MapRecord pose = new MapRecord("demo/Bumpers",
        Map.of("pressed", new FieldValue.Items(List.of(new FieldValue.Flag(false), new FieldValue.Flag(true)))));
    assertInstanceOf(Verdict.Holds.class,
        check("bumpers pressed[1] == true", signals.put("bumpers", FakeSignals.LIVE, pose)));
    assertEquals(new Verdict.Unknown("bumpers.pressed is no single value; name one of its elements or fields", true),
        check("bumpers pressed == true", signals));
  }

  @Test
  void hysteresisMakesAnAlertLastLonger() {
    Condition low = Conditions.parse("battery charge < 0.2", 0.05);
    assertInstanceOf(Verdict.Fails.class, low.check(signals.battery(0.22), false));
    assertInstanceOf(Verdict.Holds.class, low.check(signals.battery(0.22), true));
    assertInstanceOf(Verdict.Fails.class, low.check(signals.battery(0.25), true));
    Condition hot = Conditions.parse("battery voltage > 11", 2);
    assertInstanceOf(Verdict.Holds.class, hot.check(signals.battery(0.2), true));
  }

  @Test
  void aSourceIsStaleOnceItSentAndCeasedTo() {
    Condition stale = Conditions.parse("battery stale", 0);
    assertInstanceOf(Verdict.Unknown.class, stale.check(signals, false));
    assertInstanceOf(Verdict.Fails.class, stale.check(signals.battery(1), false));
    signals.state("battery", new InputState.Stale(2.5, "old"));
    assertSeen("battery sent nothing for 2.5 s", stale.check(signals, false));
    assertSeen("battery is no longer offered", stale.check(signals.gone("battery"), false));
  }

  @Test
  void aLinkIsLostOnceItWasThere() {
    Condition lost = Conditions.parse("link lost", 0);
    assertInstanceOf(Verdict.Unknown.class,
        lost.check(signals.link(new LinkState.Failed("refused", Duration.ofSeconds(1))), false));
    assertInstanceOf(Verdict.Fails.class, lost.check(signals.link(new LinkState.Connected("robot:11311")), false));
    assertSeen("the link is lost: refused",
        lost.check(signals.link(new LinkState.Failed("refused", Duration.ofSeconds(1))), false));
  }

  @Test
  void diagnosticsAreComparedByLevelAndPart() {
    Diagnostics report = new Diagnostics(List.of(
        new Diagnostics.Item("Left motor", "", Diagnostics.Level.WARNING, "52 degrees", Map.of()),
        new Diagnostics.Item("Laser", "", Diagnostics.Level.OK, "", Map.of())));
    signals.put("diagnostics", FakeSignals.LIVE, report);
    assertSeen("Left motor reports WARNING: 52 degrees", check("diagnostics >= warn", signals));
    assertInstanceOf(Verdict.Fails.class, check("diagnostics >= ERROR", signals));
    assertInstanceOf(Verdict.Holds.class, check("diagnostics motor >= WARNING", signals));
    assertInstanceOf(Verdict.Fails.class, check("diagnostics laser >= WARNING", signals));
  }

  @Test
  void logEntriesAreComparedBySeverityAndWords() {
    assertInstanceOf(Verdict.Fails.class, check("log >= ERROR", signals.logs(Severity.WARNING)));
    assertSeen("/planner says FATAL: no way to the goal (and 1 before)",
        check("log >= ERROR", signals.logs(Severity.INFO, Severity.ERROR, Severity.FATAL)));
    assertInstanceOf(Verdict.Holds.class, check("log planner >= ERROR", signals));
    assertInstanceOf(Verdict.Fails.class, check("log driver >= ERROR", signals));
    assertTrue(Conditions.parse("log \"no way\" >= ERROR", 0).momentary());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "battery", "link gone", "battery charge", "battery < 3", "battery charge < low",
      "battery charge = 3",
      "battery charge < 0.2 now", "diagnostics >= LOUD", "log >= 3", "battery a..b < 1"})
  void whatCannotBeReadIsRefusedWithAnExample(String text) {
    Exception e = assertThrows(IllegalArgumentException.class, () -> Conditions.parse(text, 0));
    assertTrue(e.getMessage().length() > 20, e.getMessage());
  }

  @Test
  void onlyWhatAConditionNeedsIsAskedFor() {
    Input.Candidate battery = new Input.Candidate(new SourceId("base", "battery"), "Battery");
    Input.Candidate scan = new Input.Candidate(new SourceId("base", "scan"), "LaserScan");
    Input.Candidate log = new Input.Candidate(new SourceId("base", "rosout"), "LogEntry");
    Condition low = Conditions.parse("battery charge < 0.2", 0);
    assertTrue(low.needs().test(battery));
    assertFalse(low.needs().test(scan));
    assertTrue(Conditions.parse("log >= ERROR", 0).needs().test(log));
    assertFalse(Conditions.parse("link lost", 0).needs().test(battery));
  }

  private static void assertSeen(String detail, Verdict verdict) {
    assertEquals(detail, assertInstanceOf(Verdict.Holds.class, verdict).detail());
  }

  private static Verdict check(String text, FakeSignals signals) {
    return Conditions.parse(text, 0).check(signals, false);
  }
}
