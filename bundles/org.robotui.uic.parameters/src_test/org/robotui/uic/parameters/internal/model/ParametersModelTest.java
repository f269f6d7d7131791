package org.robotui.uic.parameters.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.port.InputState;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.ui.ask.ControlFirst;
import org.robotui.uic.parameters.internal.ParametersOptions;

class ParametersModelTest {
  private static final long MILLI = 1_000_000;

  private final FakeUicContext context = new FakeUicContext("parameters", ParametersOptions.schema());
  private final FakeRobot robot = new FakeRobot();
  private final ParametersModel model = new ParametersModel(context);
  private List<Key> visible = List.of();
  private long now = System.nanoTime();

  @Test
  void withoutARobotTheReasonIsSaidAndNothingAsked() {
    tick();
    assertInstanceOf(InputState.Unconnected.class, model.look().state());
    connect();
    model.gone();
    model.tick(now, options());
    assertInstanceOf(InputState.Waiting.class, model.look().state());
  }

  @Test
  void namesComeFirstAndValuesOnlyWhereTheyAreSeen() {
    robot.with("/base/speed", 0.5).with("/base/name", "Keira").with("/use_sim_time", false);
    connect();
    assertEquals(List.of("base", "use_sim_time"), labels());
    assertEquals(0, robot.reads());
    visible = List.of(key("/use_sim_time"));
    ticks(2);
    assertEquals(1, robot.reads());
    assertEquals("false", row("/use_sim_time").text());
    assertEquals("bool", row("/use_sim_time").type());
    model.open(key("/base"), true);
    ticks(1);
    assertEquals(List.of("base", "name", "speed", "use_sim_time"), labels());
    assertEquals(ParameterRow.State.BUSY, row("/base/speed").state());
  }

  @Test
  void aFilterLooksIntoAllNamespacesAndKnownValues() {
    robot.with("/base/speed", 0.5).with("/arm/speed", 0.1).with("/arm/name", "left");
    connect();
    model.filter("speed");
    ticks(1);
    assertEquals(List.of("arm", "speed", "base", "speed"), labels());
    model.filter("left");
    ticks(1);
    assertEquals(List.of(), labels());
    visible = List.of(key("/arm/name"));
    ticks(2);
    assertEquals(List.of("arm", "name"), labels());
  }

  @Test
  void settingTakesTheFreeLeaseAndCanBeUndone() {
    see("/base/speed", 0.5);
    model.set(key("/base/speed"), 0.8);
    ticks(1);
    assertEquals(0.8, robot.value("/base/speed"));
    assertEquals(Optional.of(FakeAuthority.YOU), context.authority().holder());
    assertEquals(ParameterRow.State.CHANGED, row("/base/speed").state());
    assertEquals(Optional.of("0.5"), row("/base/speed").before());
    assertEquals("/base/speed", model.look().undo());
    model.undo();
    ticks(1);
    assertEquals(0.5, robot.value("/base/speed"));
    assertEquals("", model.look().undo());
    assertEquals(ParameterRow.State.KNOWN, row("/base/speed").state());
  }

  @Test
  void theLeaseOfSomebodyElseIsTakenOnlyWhenConfirmed() {
    see("/base/speed", 0.5);
    context.authority().take(FakeAuthority.ANNA, false);
    model.set(key("/base/speed"), 0.8);
    ticks(1);
    assertEquals(new ControlFirst.Question("Anna", "Keira"), model.look().question().orElseThrow());
    assertEquals(0.5, robot.value("/base/speed"));
    model.control().leave();
    ticks(1);
    assertEquals("/base/speed was not changed", model.look().told().text());
    model.set(key("/base/speed"), 0.8);
    model.control().takeOver();
    ticks(1);
    assertEquals(0.8, robot.value("/base/speed"));
    assertTrue(model.look().question().isEmpty());
  }

  @Test
  void aRefusalIsShownAtTheValueAndNothingIsUndone() {
    see("/base/speed", 0.5);
    robot.refuse(Optional.of("the stop is latched; release it first"));
    model.set(key("/base/speed"), 0.8);
    ticks(1);
    assertEquals(ParameterRow.State.WRONG, row("/base/speed").state());
    assertEquals(Health.BAD, model.look().told().health());
    assertTrue(model.look().told().text().endsWith("the stop is latched; release it first"),
        model.look().told().text());
    assertEquals("", model.look().undo());
    assertEquals(Optional.of(0.5), row("/base/speed").value());
  }

  @Test
  void whatOthersChangeIsReadAgainAndMarked() {
    see("/base/speed", 0.5);
    robot.with("/base/speed", 0.9);
    now += 5000 * MILLI;
    ticks(2);
    assertEquals("0.9", row("/base/speed").text());
    assertEquals(ParameterRow.State.CHANGED, row("/base/speed").state());
  }

  @Test
  void aRobotThatFailsSaysWhyAndKeepsWhatItSaid() {
    see("/base/speed", 0.5);
    robot.fail(Optional.of("timed out"));
    now += 10_000 * MILLI;
    ticks(2);
    assertEquals("base does not answer: timed out", model.look().notice());
    assertTrue(row("/base/speed").text().startsWith("0.5"), row("/base/speed").text());
    int reads = robot.reads();
    ticks(5);
    assertEquals(reads, robot.reads(), "it is left in peace for a while");
  }

  @Test
  void aNamespaceIsWrittenAsYaml(@TempDir Path folder) throws IOException {
    robot.with("/base/speed", 0.5).with("/base/pid/gains", List.of(1.0, 2.0)).with("/base/name", "a: b").with("/other",
        1L);
    connect();
    Path file = folder.resolve("base.yaml");
    model.export(key("/base"), file);
    assertEquals("""
        # 3 parameters of /base
        name: "a: b"
        pid:
          gains: [1.0, 2.0]
        speed: 0.5
        """, Files.readString(file));
    tick();
    assertEquals("3 parameters written to base.yaml", model.look().told().text());
  }

  @Test
  void nothingIsWrittenWhereTheRobotDoesNotAnswer(@TempDir Path folder) {
    robot.with("/base/speed", 0.5);
    connect();
    robot.fail(Optional.of("timed out"));
    Path file = folder.resolve("base.yaml");
    model.export(key("/base"), file);
    tick();
    assertEquals("Nothing was written: timed out", model.look().told().text());
    assertTrue(Files.notExists(file));
  }

  @Test
  void tenThousandParametersAreLookedAtOnlyWhenSomethingChanged() {
    for (int i = 0; i < 10_000; i++) {
      robot.with("/node%03d/group%d/value%d".formatted(i / 100, i / 10 % 10, i % 10), (long) i);
    }
    connect();
    ticks(2);
    assertEquals(100, model.look().rows().size());
    List<ParameterRow> rows = model.look().rows();
    long looked = model.looked();
    for (int i = 0; i < 200; i++) {
      tick();
    }
    assertSame(rows, model.look().rows());
    assertEquals(looked, model.looked());
    assertEquals(0, robot.reads(), "no value is seen");
  }

  @Test
  void aNameOfAMillionPartsIsBorne(@TempDir Path folder) {
    robot.with("/a".repeat(1_000_000), 1L);
    connect();
    model.filter("a");
    ticks(1);
    assertEquals(64, model.look().rows().size());
    model.export(key("/a"), folder.resolve("a.yaml"));
    tick();
    assertEquals(Health.OK, model.look().told().health(), model.look().told().text());
  }

  @Test
  void valuesAreReadAFewAtATime() {
    for (int i = 0; i < 100; i++) {
      robot.with("/v%03d".formatted(i), (long) i);
    }
    connect();
    visible = model.look().rows().stream().map(ParameterRow::key).toList();
    tick();
    assertEquals(Values.BATCH, robot.reads());
    ticks(3);
    assertEquals(100, robot.reads());
  }

  @Test
  void mapsAreShownInOneLine() {
    see("/robot", Map.of("x", List.of(1L, true, "on")));
    assertEquals("{x: [1, true, \"on\"]}", row("/robot").text());
    assertEquals("map of 1", row("/robot").type());
  }

  private void see(String name, Object value) {
    robot.with(name, value);
    connect();
    for (int at = name.indexOf('/', 1); at > 0; at = name.indexOf('/', at + 1)) {
      model.open(key(name.substring(0, at)), true);
    }
    visible = List.of(key(name));
    ticks(2);
  }

  private void connect() {
    context.robots(List.of(robot.robot("base")));
    ticks(2);
  }

  private void ticks(int count) {
    for (int i = 0; i < count; i++) {
      tick();
    }
  }

  private void tick() {
    now += 50 * MILLI;
    model.seen(now, visible);
    model.tick(now, options());
  }

  private ParameterRow row(String name) {
    return model.look().rows().stream().filter(r -> r.key().name().equals(name)).findFirst().orElseThrow();
  }

  private List<String> labels() {
    return model.look().rows().stream().map(ParameterRow::label).toList();
  }

  private ParametersOptions options() {
    return ParametersOptions.of(context.settings().current());
  }

  private static Key key(String name) {
    return new Key("base", name);
  }
}
