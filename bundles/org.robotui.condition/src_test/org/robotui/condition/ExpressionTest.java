package org.robotui.condition;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
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

class ExpressionTest {
  private final FakeSignals signals = new FakeSignals();

  /** A battery with 12 V, 19 % and a discharge of 1 A, and wheels that turn. */
  @BeforeEach
  void robot() {
    signals.battery(0.19).put("/front-scan", new InputState.Live(8.5, 0.4), wheels(0, true))
        .put("wheels", FakeSignals.LIVE, wheels(-2, true)).link(new LinkState.Connected("robot"));
  }

  private static MapRecord wheels(double speed, boolean on) {
    return new MapRecord("demo/Wheels",
        Map.of("speed", new FieldValue.Num(speed, Double.toString(speed)), "on", new FieldValue.Flag(on)));
  }

  @ParameterizedTest
  @ValueSource(strings = {
      "battery charge < 0.2 and wheels speed < 0", "battery charge > 0.2 or wheels on", "not battery charge > 0.2",
      "not (battery charge > 0.2 or wheels speed > 0)", "battery voltage * battery current == -12",
      "battery voltage - 2 * 3 == 6", "(battery voltage - 2) * 3 == 30", "battery voltage / 4 >= 3",
      "abs(wheels speed) > 1.5", "max(wheels speed, battery voltage, 3) == 12", "min(wheels speed, 3) < -1",
      "- wheels speed > 1", "battery charge < wheels speed + 3", "wheels on and not wheels on == false",
      "wheels on == true and battery status == discharging", "battery status == 'discharging' or link lost",
      "age(/front-scan) < 0.5 and rate(front-scan) > 8", "rate(base.wheels) >= 10",
      "battery charge > 1 or battery charge > 0.5 or battery charge > 0.1",
      "battery charge > 1 and nothing there < 2 or wheels on"})
  void theseHold(String text) {
    assertInstanceOf(Verdict.Holds.class, check(text), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {
      "battery charge < 0.2 and wheels speed > 0", "not wheels on", "not not battery charge > 0.2",
      "battery charge > 0.2 and nothing there < 2", "(battery charge < 0.2) == false", "link lost and wheels on"})
  void theseDoNot(String text) {
    assertInstanceOf(Verdict.Fails.class, check(text), text);
  }

  @Test
  void whatCannotBeToldLeavesOpenWhatDependsOnIt() {
    assertEquals(new Verdict.Unknown("nothing called 'nothing' is offered", false),
        check("battery charge < 0.2 and nothing there < 2"));
    assertEquals(new Verdict.Unknown("bumper has not sent anything yet", false), check("age(bumper) > 2"));
    signals.state("battery", new InputState.Stale(3, "old"));
    assertEquals(new Verdict.Unknown("battery sends nothing now", false), check("not (battery charge < 0.2)"));
    assertInstanceOf(Verdict.Holds.class, check("age(battery) > 2 and rate(battery) == 0"));
  }

  @Test
  void itSaysWhatWasSeen() {
    Verdict.Holds holds = assertInstanceOf(Verdict.Holds.class,
        check("battery charge < 0.2 and abs(wheels speed) > 1 and age(front-scan) < 1"));
    assertEquals("battery.charge, wheels.speed, the age of /front-scan are 0.19, -2, 0.4 s",
        holds.detail().replace("-2.0", "-2"));
  }

  @Test
  void diagnosticsAndSilenceCanBeCombined() {
    signals.put("diagnostics", FakeSignals.LIVE, new Diagnostics(
        List.of(new Diagnostics.Item("Left motor", "", Diagnostics.Level.WARNING, "52 degrees", Map.of()))));
    assertInstanceOf(Verdict.Holds.class, check("diagnostics motor >= WARNING and link lost or diagnostics >= warn"));
    assertInstanceOf(Verdict.Fails.class, check("diagnostics \"left motor\" >= ERROR or link lost"));
    Condition silent = Conditions.parse("wheels stale and battery charge < 0.2", 0);
    assertInstanceOf(Verdict.Fails.class, silent.check(signals, false));
    signals.state("wheels", new InputState.Stale(4, "old"));
    assertInstanceOf(Verdict.Holds.class, silent.check(signals, false));
  }

  @Test
  void hysteresisMakesEveryPartLastLonger() {
    Condition low = Conditions.parse("battery charge < 0.2 and not battery voltage > 13", 0.05);
    assertInstanceOf(Verdict.Fails.class, low.check(signals.battery(0.22), false));
    assertInstanceOf(Verdict.Holds.class, low.check(signals.battery(0.22), true));
    Condition turned = Conditions.parse("not (battery charge >= 0.2)", 0.05);
    assertInstanceOf(Verdict.Fails.class, turned.check(signals.battery(0.22), false));
    assertInstanceOf(Verdict.Holds.class, turned.check(signals.battery(0.22), true));
    assertInstanceOf(Verdict.Fails.class, turned.check(signals.battery(0.26), true));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
      "battery charge < 0.2 and|25|a source and a field",
      "battery charge < 0.2 and 3|26|no condition",
      "3 and battery charge < 0.2|1|compare it before 'and'",
      "(battery charge < 0.2|22|')' is missing",
      "battery charge < 0.2) or link lost|21|'and', 'or' or the end",
      "battery charge + wheels < 3|18|its field is missing",
      "older(scan) > 3|1|age(SOURCE)",
      "age() > 3|5|the name of a source",
      "battery charge < 0.2 or log >= ERROR|25|does not last",
      "not battery status < full|20|no order",
      "battery a..b < 1 or link lost|9|",
      "wheels on + 'x' > 3|13|its field is missing",
      "-wheels speed > 1 and wheels on|1|a blank behind the minus",
      "battery charge < 0.2 an (wheels on)|22|'and', 'or' or the end"})
  void whatCannotBeReadIsRefusedWithItsColumn(String text, int column, String why) {
    Exception e = assertThrows(IllegalArgumentException.class, () -> Conditions.parse(text, 0));
    assertTrue(e.getMessage().contains("column " + column + " "), e.getMessage());
    assertTrue(why == null || e.getMessage().contains(why), e.getMessage());
  }

  @Test
  void itIsNotNestedWithoutAnEnd() {
    Exception e = assertThrows(IllegalArgumentException.class,
        () -> Conditions.parse("(".repeat(2000) + "wheels on" + ")".repeat(2000), 0));
    assertTrue(e.getMessage().contains("too deeply"));
    assertThrows(IllegalArgumentException.class, () -> Conditions.parse("- ".repeat(5000) + "wheels on > 3", 0));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
      "battery status + 1 > 3|one counts with numbers only",
      "battery status and wheels on|'DISCHARGING' is not true or false",
      "battery charge == wheels on and wheels on|cannot be compared by =="})
  void whatCanNeverHoldIsSaid(String text, String why) {
    Verdict.Unknown unknown = assertInstanceOf(Verdict.Unknown.class, check(text));
    assertTrue(unknown.wrong());
    assertTrue(unknown.reason().contains(why), unknown.reason());
  }

  @Test
  void allThatItNamesIsAskedForAndNothingElse() {
    Condition condition = Conditions.parse("battery charge < 0.2 and age(scan) > 2 and not wheels stale", 0);
    assertTrue(condition.needs().test(candidate("battery")));
    assertTrue(condition.needs().test(candidate("scan")));
    assertTrue(condition.needs().test(candidate("wheels")));
    assertFalse(condition.needs().test(candidate("map")));
    assertFalse(condition.momentary());
  }

  private static Input.Candidate candidate(String port) {
    return new Input.Candidate(new SourceId("base", port), "Data");
  }

  private Verdict check(String text) {
    return Conditions.parse(text, 0).check(signals, false);
  }
}
