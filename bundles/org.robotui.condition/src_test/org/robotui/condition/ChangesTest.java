package org.robotui.condition;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.sensor.Battery;
import org.robotui.data.status.Diagnostics;

class ChangesTest {
  private final FakeSignals signals = new FakeSignals();

  private Verdict check(Condition condition) {
    return condition.check(signals, false);
  }

  private void battery(Battery.Status status) {
    signals.put("battery", FakeSignals.LIVE, new Battery(12, -1, 0.5, status));
  }

  private void level(Diagnostics.Level level) {
    signals.put("diagnostics", FakeSignals.LIVE, new Diagnostics(List.of(
        new Diagnostics.Item("motor left", "hw", level, "hot", Map.of()),
        new Diagnostics.Item("camera", "hw", Diagnostics.Level.OK, "", Map.of()))));
  }

  @Test
  void whatIsAnotherWordThanBeforeHasChanged() {
    Condition changes = Conditions.parse("battery status changes", 0);
    assertTrue(changes.momentary());
    assertInstanceOf(Verdict.Unknown.class, check(changes));
    battery(Battery.Status.CHARGING);
    assertInstanceOf(Verdict.Fails.class, check(changes), "the first one is no change");
    battery(Battery.Status.FULL);
    assertEquals("battery.status is FULL, was CHARGING", ((Verdict.Holds) check(changes)).detail());
    assertInstanceOf(Verdict.Fails.class, check(changes));
  }

  @ParameterizedTest
  @CsvSource({"diagnostics changes, true", "diagnostics MOTOR changes, true", "diagnostics camera changes, false"})
  void aLevelThatIsAnotherOneHasChanged(String text, boolean found) {
    Condition changes = Conditions.parse(text, 0);
    level(Diagnostics.Level.OK);
    assertInstanceOf(Verdict.Fails.class, check(changes));
    level(Diagnostics.Level.ERROR);
    Verdict verdict = check(changes);
    assertEquals(found, verdict instanceof Verdict.Holds);
    if (verdict instanceof Verdict.Holds holds) {
      assertEquals("motor left reports ERROR: hot (was OK)", holds.detail());
    }
  }

  @Test
  void aDelayIsThatOfTheNewestValue() {
    battery(Battery.Status.FULL);
    Condition late = Conditions.parse("delay(battery) > 0.1", 0);
    assertInstanceOf(Verdict.Unknown.class, check(late), "without a stamp nothing is late");
    signals.delay("battery", 0.25);
    assertEquals("the delay of battery is 0.250 s", ((Verdict.Holds) check(late)).detail());
    signals.delay("battery", 0.05);
    assertInstanceOf(Verdict.Fails.class, check(late));
  }

  @ParameterizedTest
  @ValueSource(strings = {"battery changes", "battery status changes and battery charge < 1",
      "not battery status changes", "battery status changes for 5 s", "log >= ERROR for 2 s"})
  void theseSayNothing(String text) {
    assertThrows(IllegalArgumentException.class, () -> TimedCondition.parse(text, 0), text);
  }

  @ParameterizedTest
  @CsvSource({"battery charge < 0.2 for 5 s, 5e9", "battery charge < 0.2 for 1.5min, 90e9",
      "battery charge < 0.2 for 20 ms, 20e6", "battery charge < 0.2 and link lost for 1 h, 3600e9",
      "battery charge < 0.2, 0"})
  void aTimeStandsBehind(String text, double nanos) {
    assertEquals(nanos, TimedCondition.parse(text, 0).forNanos(), 0);
  }
}
