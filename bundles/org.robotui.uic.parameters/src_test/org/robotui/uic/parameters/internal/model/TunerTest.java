package org.robotui.uic.parameters.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.ask.ControlFirst;
import org.robotui.uic.parameters.internal.ParametersOptions;

class TunerTest {
  private static final long MILLI = 1_000_000;
  private static final long PERIOD = 3000 * MILLI;

  private final FakeUicContext context = new FakeUicContext("parameters", ParametersOptions.schema());
  private final FakeRobot robot = new FakeRobot().server("/camera",
      FakeRobot.number("gain", "", 0.5, 0.5, 0, 1, "gain"), FakeRobot.plain("auto", "", true, true, "automatic"));
  private final Deque<Runnable> tasks = new ArrayDeque<>();
  private final ControlFirst control = new ControlFirst(context);
  private final Tuner tuner = new Tuner(new Key("base", "/camera"), robot, tasks::add, control);
  private long now = System.nanoTime();

  @BeforeEach
  void read() {
    run(50);
  }

  @Test
  void settingsAreReadAndFollowedSlowly() {
    assertTrue(tuner.panel().known());
    assertEquals(1, robot.polls());
    robot.elsewhere("/camera", "gain", 0.7);
    run(2800);
    assertEquals(0.5, gain().value());
    run(400);
    assertEquals(0.7, gain().value());
    assertEquals(2, robot.polls());
  }

  @Test
  void aDraggedSliderSendsTenTimesASecondAndItsLastValue() {
    for (int i = 0; i <= 100; i++) {
      tuner.set("gain", i / 100.0);
      run(10);
    }
    run(200);
    assertTrue(robot.sent().size() <= 12, "sent " + robot.sent().size());
    assertEquals(Map.of("gain", 1.0), robot.sent().getLast());
    assertEquals(1.0, gain().value());
    assertFalse(gain().pending());
  }

  @Test
  void aSlowProgramIsSentOneChangeAtATime() {
    tuner.set("gain", 0.1);
    tick(100);
    tuner.set("gain", 0.2);
    tuner.set("gain", 0.3);
    tick(500);
    assertEquals(1, tasks.size());
    assertEquals(0.3, gain().value());
    assertTrue(gain().pending());
    run(200);
    assertEquals(2, robot.sent().size());
    assertEquals(Map.of("gain", 0.3), robot.sent().getLast());
  }

  @Test
  void aRefusalIsShownAtTheFieldAndTheOldValueIsBack() {
    robot.refuse(Optional.of("the program said no"));
    tuner.set("gain", 0.9);
    run(200);
    assertEquals(0.5, gain().value());
    assertEquals(Optional.of("the program said no"), gain().problem());
    robot.refuse(Optional.empty());
    tuner.set("gain", 0.8);
    run(200);
    assertEquals(Optional.empty(), gain().problem());
  }

  @Test
  void nothingIsSentBeforeTheUserTookOver() {
    context.authority().take(FakeAuthority.ANNA, false);
    tuner.set("gain", 0.9);
    tuner.set("gain", 0.95);
    run(500);
    assertEquals(0, robot.sent().size());
    assertTrue(control.question().isPresent());
    control.takeOver();
    run(200);
    assertEquals(Map.of("gain", 0.95), robot.sent().getLast());
  }

  @Test
  void whoDoesNotTakeOverChangesNothing() {
    context.authority().take(FakeAuthority.ANNA, false);
    tuner.set("gain", 0.9);
    control.leave();
    run(500);
    assertEquals(0, robot.sent().size());
    assertEquals(0.5, gain().value());
  }

  @Test
  void defaultsAreRestoredTogether() {
    tuner.set("gain", 0.9);
    tuner.set("auto", false);
    run(200);
    assertFalse(gain().isDefault());
    tuner.restore();
    run(200);
    assertEquals(Map.of("gain", 0.5, "auto", true), robot.sent().getLast());
    assertTrue(gain().isDefault());
  }

  @Test
  void aProgramThatDoesNotAnswerSaysWhy() {
    robot.fail(Optional.of("timed out"));
    run(4000);
    assertEquals(Optional.of("timed out"), tuner.panel().failure());
    robot.fail(Optional.empty());
    run(4000);
    assertEquals(Optional.empty(), tuner.panel().failure());
  }

  private Knob gain() {
    return tuner.panel().knobs().getFirst();
  }

  private void run(int millis) {
    for (int i = 0; i < millis; i += 10) {
      tick(10);
      for (Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
        task.run();
      }
    }
  }

  private void tick(int millis) {
    now += millis * MILLI;
    tuner.tick(now, PERIOD);
  }
}
