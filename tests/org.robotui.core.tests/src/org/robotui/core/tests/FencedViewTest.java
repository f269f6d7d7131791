package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.RuicState;
import org.robotui.testkit.MachineLoad;

/** A view that misbehaves fails alone, the user reads which bundle it was, and what it moved is stopped. */
class FencedViewTest {
  private static final Duration LIMIT = Duration.ofSeconds(5);
  private static final String LATE = "The view 'Bad view' took longer than 2 s to answer; it is started again in ";
  private static final long SOON_NANOS = 1_500_000_000L;

  private @TempDir Path folder;
  private Fence fence;

  @BeforeEach
  void start() throws Exception {
    fence = new Fence(folder);
  }

  @AfterEach
  void end() throws Exception {
    fence.close();
  }

  private void assertFencedFor(String what) {
    String reason = fence.awaitFenced();
    assertTrue(reason.contains(what), reason);
    assertTrue(reason.contains("(bundle org.robotui.tests.bad, class org.robotui.tests.bad.BadView"), reason);
    fence.world.awaitAlert("Keira: bad failed: " + reason);
    fence.assertTheOthersGoOn();
  }

  /** It is started again after a pause: what is asked for may be over, but was told. */
  private void assertLate(String what) throws Exception {
    fence.world.awaitAlert("Keira: " + what);
    fence.assertTheOthersGoOn();
  }

  @Test
  void anExceptionInTick() throws Exception {
    fence.view("in: tick, does: throw, after: 0.2");
    assertFencedFor("threw java.lang.IllegalStateException: a bug in tick");
    fence.world.awaitNoThread("Keira.bad");
  }

  @Test
  void anExceptionWhoseMessageThrows() throws Exception {
    fence.view("in: tick, does: throw_hostile");
    assertFencedFor("threw org.robotui.tests.bad.HostileException in tick");
  }

  @Test
  void anAssertionInTick() throws Exception {
    fence.view("in: tick, does: assert");
    assertFencedFor("threw java.lang.AssertionError: an invariant in tick");
  }

  @Test
  void aStackOverflowInTick() throws Exception {
    fence.view("in: tick, does: overflow");
    assertFencedFor("threw java.lang.StackOverflowError in tick");
  }

  @Test
  void aMissingClassInTick() throws Exception {
    fence.view("in: tick, does: no_class");
    assertFencedFor("threw java.lang.NoClassDefFoundError: org/robotui/gone/Library in tick");
  }

  @Test
  void anErrorInCreate() throws Exception {
    fence.view("in: create, does: overflow");
    String reason = fence.awaitFenced();
    assertTrue(reason.contains("threw java.lang.StackOverflowError in create (bundle org.robotui.tests.bad"), reason);
    fence.assertTheOthersGoOn();
  }

  @Test
  void aCreateThatNeverReturns() throws Exception {
    fence.view("in: create, does: wait_deaf");
    String reason = fence.awaitFenced();
    assertTrue(reason.contains("did not return from create within 10.0 s (bundle org.robotui.tests.bad"), reason);
    assertTrue(reason.contains("threads left: Keira.bad-1"), reason);
    fence.assertTheOthersGoOn();
  }

  @Test
  void aTickThatWaitsForEverIsInterruptedAndLeavesNoThread() throws Exception {
    fence.view("in: tick, does: wait, after: 0.2");
    fence.assertTheOthersGoOn();
    assertLate(LATE + "2 s.");
    fence.world.awaitNoThread("Keira.bad");
    assertLate(LATE + "4 s.");
  }

  @Test
  void aTickThatIsDeafIsNamedWithItsThread() throws Exception {
    fence.view("in: tick, does: wait_deaf");
    assertLate(LATE);
    fence.world.awaitAlert("It could not be ended: bad hangs in tick; threads left: Keira.bad-2");
    assertLate("The view 'Bad view' still does not answer; it is started again in 4 s.");
    Eventually.await("all but it have ended", () -> World.threads("Keira.bad").equals(List.of("Keira.bad-2")),
        () -> World.threads("Keira.bad"));
  }

  @Test
  void aTickThatSpinsCostsACoreAndNothingElse() throws Exception {
    fence.view("in: tick, does: spin");
    assertLate(LATE);
  }

  @Test
  void whatItMovedIsStoppedWhenItThrows() throws Exception {
    fence.view("in: tick, does: throw, after: 1, drives: true");
    fence.wheels.awaitMoving();
    assertFencedFor("a bug in tick");
    fence.wheels.awaitStopped();
  }

  @Test
  void whatItMovedIsStoppedWhenItHangs() throws Exception {
    fence.view("in: tick, does: wait_deaf, after: 1, drives: true");
    fence.wheels.awaitMoving();
    assertLate(LATE);
    long gone = fence.wheels.awaitStopped() - fence.wheels.commands().reversed().stream().filter(c -> !c.isZero())
        .findFirst().orElseThrow().nanos();
    assertTrue(gone < 2_000_000_000L + SOON_NANOS * MachineLoad.factor(),
        "its last command would have been valid for a minute, and was for " + gone);
  }

  @Test
  void aTaskThatThrowsIsToldOnceAndTheViewGoesOn() throws Exception {
    fence.view("in: task, does: overflow");
    fence.world.awaitAlert("Keira: bad threw java.lang.StackOverflowError in a task (bundle org.robotui.tests.bad");
    fence.assertTheOthersGoOn();
    fence.world.await("bad", RuicState.SELECTED);
    assertEquals(1, fence.world.alerts().stream().filter(a -> a.contains("in a task")).count());
  }

  @Test
  void aTaskThatNeverEndsIsNamedAtTheEnd() throws Exception {
    fence.view("in: task, does: wait_deaf");
    fence.assertTheOthersGoOn();
    fence.world.await("bad", RuicState.SELECTED);
    String left = fence.close(LIMIT).toString();
    assertTrue(left.contains("bad has ended; threads left: Keira.bad-"), left);
    assertTrue(left.contains("(bundle org.robotui.tests.bad, class "), left);
  }

  @Test
  void aCloseThatThrowsIsToldAtTheEnd() throws Exception {
    fence.view("in: close, does: assert");
    fence.world.await("bad", RuicState.SELECTED);
    String left = fence.close(LIMIT).toString();
    assertTrue(left.contains("bad threw java.lang.AssertionError: an invariant in close (bundle org.robotui.tests.bad"),
        left);
  }

  @Test
  void aThreadBesideTheFactoryThatIsDeafIsNamedAtTheEnd() throws Exception {
    fence.view("in: create, does: leak");
    fence.world.await("bad", RuicState.SELECTED);
    String left = fence.close(LIMIT).toString();
    assertTrue(left.matches(".*bad has ended; threads left: leaked-\\d+ \\(bundle org.robotui.tests.bad, class .*"),
        left);
    assertEquals(1, World.threads("leaked-").size());
  }

  @Test
  void aThreadBesideTheFactoryIsInterruptedAtTheEnd() throws Exception {
    fence.view("in: create, does: leak_polite");
    fence.world.await("bad", RuicState.SELECTED);
    assertEquals(1, World.threads("leaked-").size());
    assertEquals(List.of(), fence.close(LIMIT.multipliedBy(6)));
    fence.world.awaitNoThread("leaked-");
  }

  @Test
  void aThreadBesideTheFactoryThatThrowsFailsItsView() throws Exception {
    fence.view("in: create, does: leak_throwing");
    String reason = fence.awaitFenced();
    assertTrue(reason.matches("its thread leaked-\\d+ ended with java.lang.IllegalStateException: a bug \\(bundle "
        + "org.robotui.tests.bad, class .*"), reason);
    fence.assertTheOthersGoOn();
  }

  @Test
  void framesWithoutEndDoNotKeepOthersFromBeingSeen() throws Exception {
    fence.view("in: nowhere");
    fence.world.awaitFrames("Keira.bad", 100);
    fence.world.awaitFrames("Keira.pulse", 10);
    fence.world.awaitFrames("Lara.pulse", 10);
    fence.assertTheOthersGoOn();
    assertFalse(fence.world.alerts().stream().anyMatch(a -> a.contains("bad")), fence.world.alerts().toString());
  }
}
