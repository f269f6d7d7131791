package org.robotui.uic.sound.internal.alert;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.status.Severity;
import org.robotui.uic.sound.internal.alert.Alert.State;
import org.robotui.uic.sound.internal.alert.Alert.Step;
import org.robotui.uic.sound.internal.tone.Sound;
import org.robotui.uic.sound.internal.tone.Tone;

class AlertTest {
  private final FakeSignals signals = new FakeSignals().battery(1);

  @Test
  void anAlertBeginsRepeatsAndEnds() {
    Alert alert = alert("battery charge < 0.2", 0, 0, 10);
    assertEquals(Step.NONE, at(alert, 0));
    assertEquals(State.QUIET, alert.state());
    signals.battery(0.1);
    assertEquals(Step.RAISED, at(alert, 1));
    assertEquals(Step.LASTS, at(alert, 10.9));
    assertEquals(Step.REPEATED, at(alert, 11));
    assertEquals(Step.LASTS, at(alert, 20));
    signals.battery(0.5);
    assertEquals(Step.ENDED, at(alert, 22));
    assertEquals(Step.NONE, at(alert, 23));
  }

  @Test
  void withoutARepeatItIsHeardOnce() {
    Alert alert = alert("battery charge < 0.2", 0, 0, 0);
    signals.battery(0.1);
    assertEquals(Step.RAISED, at(alert, 0));
    assertEquals(Step.LASTS, at(alert, 1000));
  }

  @Test
  void aConditionMustHoldForItsTimeWithoutABreak() {
    Alert alert = alert("battery charge < 0.2", 0, 3, 0);
    signals.battery(0.1);
    assertEquals(Step.NONE, at(alert, 0));
    assertEquals(State.PENDING, alert.state());
    assertEquals(Step.NONE, at(alert, 2));
    signals.battery(0.3);
    assertEquals(Step.NONE, at(alert, 2.5));
    signals.battery(0.1);
    assertEquals(Step.NONE, at(alert, 3.5));
    assertEquals(Step.RAISED, at(alert, 6.5));
  }

  @Test
  void atItsLimitAnAlertDoesNotFlutter() {
    Alert alert = alert("battery charge < 0.2", 0.05, 0, 0);
    signals.battery(0.19);
    assertEquals(Step.RAISED, at(alert, 0));
    signals.battery(0.21);
    assertEquals(Step.LASTS, at(alert, 1));
    signals.battery(0.19);
    assertEquals(Step.LASTS, at(alert, 2));
    signals.battery(0.26);
    assertEquals(Step.ENDED, at(alert, 3));
  }

  @Test
  void whatIsNotKnownIsNotHeardAndNotOver() {
    Alert alert = alert("battery charge < 0.2", 0, 0, 5);
    signals.battery(0.1);
    assertEquals(Step.RAISED, at(alert, 0));
    signals.state("battery", new InputState.Stale(3, "link lost"));
    assertEquals(Step.NONE, at(alert, 10));
    assertEquals(State.UNKNOWN, alert.state());
    signals.battery(0.1);
    assertEquals(Step.REPEATED, at(alert, 11));
  }

  @Test
  void aWrongConditionIsToldOnce() {
    Alert alert = alert("text data < 0.2", 0, 0, 5);
    assertEquals(Step.NONE, at(alert, 0));
    text("on");
    assertEquals(Step.WRONG, at(alert, 1));
    text("off");
    assertEquals(Step.NONE, at(alert, 2));
  }

  @Test
  void everyLogEntryIsToldButAFloodOnlyNowAndThen() {
    Alert alert = alert("log >= ERROR", 0, 0, 2);
    signals.logs(Severity.ERROR);
    assertEquals(Step.RAISED, at(alert, 0));
    assertEquals(Step.NONE, at(alert, 1));
    assertEquals(Step.RAISED, at(alert, 2));
    signals.logs();
    assertEquals(Step.NONE, at(alert, 3));
    assertEquals(State.QUIET, alert.state());
    signals.logs(Severity.ERROR);
    assertEquals(Step.RAISED, at(alert, 5));
  }

  private void text(String words) {
    signals.put("text", FakeSignals.LIVE, new MapRecord("std_msgs/String", Map.of("data", new FieldValue.Text(words))));
  }

  private Step at(Alert alert, double seconds) {
    return alert.step(signals, Math.round(seconds * 1e9));
  }

  private static Alert alert(String when, double slack, double forSeconds, double repeat) {
    return new Alert(new AlertConfig(when, when, Conditions.parse(when, slack), new Sound.Made(Tone.BEEP), 1, "",
        Math.round(forSeconds * 1e9), Math.round(repeat * 1e9), false));
  }
}
