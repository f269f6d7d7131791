package org.robotui.uic.sound.internal.alert;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Input;
import org.robotui.condition.Condition;
import org.robotui.condition.Signals;
import org.robotui.condition.SourceName;
import org.robotui.condition.Verdict;
import org.robotui.data.status.LogEntry;
import org.robotui.uic.sound.internal.alert.Alert.State;
import org.robotui.uic.sound.internal.alert.Alert.Step;
import org.robotui.uic.sound.internal.tone.Sound;
import org.robotui.uic.sound.internal.tone.Tone;

class AlertTest {
  /** Holds below a fifth; what was heard of it is the test's. */
  private static final class Charge implements Condition {
    private final double slack;
    private final boolean momentary;
    private Verdict unknown = new Verdict.Fails();
    private double charge = 1;

    private Charge(double slack, boolean momentary) {
      this.slack = slack;
      this.momentary = momentary;
    }

    private void is(double now) {
      charge = now;
      unknown = new Verdict.Fails();
    }

    @Override
    public Verdict check(Signals signals, boolean active) {
      boolean holds = charge < 0.2 + (active ? slack : 0);
      return holds && unknown instanceof Verdict.Fails
          ? new Verdict.Holds("battery", "is", Double.toString(charge))
          : unknown;
    }

    @Override
    public Predicate<Input.Candidate> needs() {
      return candidate -> true;
    }

    @Override
    public boolean momentary() {
      return momentary;
    }
  }

  /** The condition looks at nothing else. */
  private static final Signals NOTHING = new Signals() {
    @Override
    public List<Reading> readings(SourceName name) {
      return List.of();
    }

    @Override
    public List<Reading> readings(String typeName) {
      return List.of();
    }

    @Override
    public List<LogEntry> log() {
      return List.of();
    }

    @Override
    public LinkState link() {
      return new LinkState.Disconnected();
    }
  };

  private Charge battery = new Charge(0, false);

  @Test
  void anAlertBeginsRepeatsAndEnds() {
    Alert alert = alert(0, 0, 10);
    assertEquals(Step.NONE, at(alert, 0));
    assertEquals(State.QUIET, alert.state());
    battery.is(0.1);
    assertEquals(Step.RAISED, at(alert, 1));
    assertEquals(Step.LASTS, at(alert, 10.9));
    assertEquals(Step.REPEATED, at(alert, 11));
    assertEquals(Step.LASTS, at(alert, 20));
    battery.is(0.5);
    assertEquals(Step.ENDED, at(alert, 22));
    assertEquals(Step.NONE, at(alert, 23));
  }

  @Test
  void withoutARepeatItIsHeardOnce() {
    Alert alert = alert(0, 0, 0);
    battery.is(0.1);
    assertEquals(Step.RAISED, at(alert, 0));
    assertEquals(Step.LASTS, at(alert, 1000));
  }

  @Test
  void aConditionMustHoldForItsTimeWithoutABreak() {
    Alert alert = alert(0, 3, 0);
    battery.is(0.1);
    assertEquals(Step.NONE, at(alert, 0));
    assertEquals(State.PENDING, alert.state());
    assertEquals(Step.NONE, at(alert, 2));
    battery.is(0.3);
    assertEquals(Step.NONE, at(alert, 2.5));
    battery.is(0.1);
    assertEquals(Step.NONE, at(alert, 3.5));
    assertEquals(Step.RAISED, at(alert, 6.5));
  }

  @Test
  void atItsLimitAnAlertDoesNotFlutter() {
    Alert alert = alert(0.05, 0, 0);
    battery.is(0.19);
    assertEquals(Step.RAISED, at(alert, 0));
    battery.is(0.21);
    assertEquals(Step.LASTS, at(alert, 1));
    battery.is(0.19);
    assertEquals(Step.LASTS, at(alert, 2));
    battery.is(0.26);
    assertEquals(Step.ENDED, at(alert, 3));
  }

  @Test
  void whatIsNotKnownIsNotHeardAndNotOver() {
    Alert alert = alert(0, 0, 5);
    battery.is(0.1);
    assertEquals(Step.RAISED, at(alert, 0));
    battery.unknown = new Verdict.Unknown("link lost", false);
    assertEquals(Step.NONE, at(alert, 10));
    assertEquals(State.UNKNOWN, alert.state());
    battery.is(0.1);
    assertEquals(Step.REPEATED, at(alert, 11));
  }

  @Test
  void aWrongConditionIsToldOnce() {
    Alert alert = alert(0, 0, 5);
    assertEquals(Step.NONE, at(alert, 0));
    battery.unknown = new Verdict.Unknown("it is a word", true);
    assertEquals(Step.WRONG, at(alert, 1));
    assertEquals(Step.NONE, at(alert, 2));
  }

  @Test
  void everyLogEntryIsToldButAFloodOnlyNowAndThen() {
    battery = new Charge(0, true);
    Alert alert = alert(0, 0, 2);
    battery.is(0.1);
    assertEquals(Step.RAISED, at(alert, 0));
    assertEquals(Step.NONE, at(alert, 1));
    assertEquals(Step.RAISED, at(alert, 2));
    battery.is(1);
    assertEquals(Step.NONE, at(alert, 3));
    assertEquals(State.QUIET, alert.state());
    battery.is(0.1);
    assertEquals(Step.RAISED, at(alert, 5));
  }

  private static Step at(Alert alert, double seconds) {
    return alert.step(NOTHING, Math.round(seconds * 1e9));
  }

  private Alert alert(double slack, double forSeconds, double repeat) {
    battery = slack > 0 ? new Charge(slack, false) : battery;
    return new Alert(new AlertConfig("charge", "charge", battery, new Sound.Made(Tone.BEEP), 1, "",
        Math.round(forSeconds * 1e9), Math.round(repeat * 1e9), false,
        Optional.empty()));
  }
}
