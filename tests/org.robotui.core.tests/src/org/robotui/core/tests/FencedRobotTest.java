package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.RuicState;
import org.robotui.testkit.MachineLoad;

/**
 * A robot interface that misbehaves fails alone, the user reads which bundle it was, and what we move through it is
 * stopped.
 */
class FencedRobotTest {
  private static final Duration LIMIT = Duration.ofSeconds(5);
  private static final String DRIVER = "      driver: driver";

  private @TempDir Path folder;
  private Fence fence;
  private Path notes;

  @BeforeEach
  void start() throws Exception {
    notes = folder.resolve("commands");
    fence = new Fence(folder);
    fence.world.bring(new Pulse("driver", true));
  }

  @AfterEach
  void end() throws Exception {
    fence.close();
  }

  /** Beside a view that moves both robots of the RUIC. */
  private void driven(String settings) throws IOException {
    fence.load("      bad: {type: badrobot, file: " + notes + ", " + settings + "}", DRIVER);
    fence.wheels.awaitMoving();
  }

  private void assertFencedFor(String what) {
    String reason = fence.awaitFenced();
    assertTrue(reason.contains(what), reason);
    assertTrue(reason.contains("(bundle org.robotui.tests.bad, class org.robotui.tests.bad.BadRobot"), reason);
    fence.world.awaitAlert("Keira: bad failed: " + reason);
    fence.assertTheOthersGoOn();
  }

  private String lastCommand() {
    try {
      List<String> all = Files.exists(notes) ? Files.readAllLines(notes) : List.of();
      return all.isEmpty() ? "" : all.getLast().replaceFirst("\\d+ ", "");
    } catch (IOException e) {
      return e.toString();
    }
  }

  private void assertTheGoodOneStillMoves() {
    int before = fence.wheels.commands().size();
    Eventually.await("commands come", () -> fence.wheels.commands().size() > before + 10,
        fence.wheels.commands()::size);
    fence.wheels.awaitMoving();
  }

  @Test
  void anErrorInCreate() throws Exception {
    fence.robot("in: create, does: overflow");
    assertFencedFor("threw java.lang.StackOverflowError in create");
  }

  @Test
  void anErrorInStart() throws Exception {
    fence.robot("in: start, does: no_class");
    assertFencedFor("threw java.lang.NoClassDefFoundError: org/robotui/gone/Library in start");
    fence.world.awaitNoThread("Keira.bad");
  }

  @Test
  void aStartThatNeverReturns() throws Exception {
    fence.robot("in: start, does: wait_deaf");
    assertFencedFor("did not return from start within 10.0 s");
    assertTrue(fence.world.reason("bad").contains("threads left: Keira.bad-"), fence.world.reason("bad"));
  }

  @Test
  void anErrorInItsThreadStopsWhatWeMoveThroughItAndNothingElse() throws Exception {
    driven("in: thread, does: overflow, after: 2");
    Eventually.await("it moves", () -> lastCommand().equals("1.0"), this::lastCommand);
    assertFencedFor("ended with java.lang.StackOverflowError");
    Eventually.await("it is stopped", () -> lastCommand().equals("0.0"), this::lastCommand);
    assertTheGoodOneStillMoves();
  }

  @Test
  void aThreadThatIsDeafIsNamedAtTheEnd() throws Exception {
    fence.robot("in: thread, does: spin");
    fence.world.await("bad", RuicState.INITIALIZED);
    fence.assertTheOthersGoOn();
    String left = fence.close(LIMIT).toString();
    assertTrue(left.matches(".*bad has ended; threads left: Keira.bad-\\d+ \\(bundle org.robotui.tests.bad, class .*"),
        left);
  }

  @Test
  void aThreadBesideTheFactoryIsNamedAtTheEnd() throws Exception {
    fence.robot("in: start, does: leak");
    fence.world.await("bad", RuicState.INITIALIZED);
    String left = fence.close(LIMIT).toString();
    assertTrue(left.matches(".*bad has ended; threads left: leaked-\\d+ \\(bundle org.robotui.tests.bad, class .*"),
        left);
  }

  @Test
  void anErrorInSendIsToldAndTheOtherRobotMovesOn() throws Exception {
    driven("in: send, does: overflow");
    fence.world.awaitAlert("bad.cmd_vel: the robot interface failed to send: java.lang.StackOverflowError "
        + "(bundle org.robotui.tests.bad, class ");
    assertTheGoodOneStillMoves();
    fence.assertTheOthersGoOn();
    fence.world.await("bad", RuicState.INITIALIZED);
  }

  @Test
  void aSendThatFailsOnceIsFollowedByTheStop() throws Exception {
    driven("in: send, does: assert, after: 2");
    fence.world.awaitAlert("java.lang.AssertionError: an invariant (bundle org.robotui.tests.bad");
    fence.keira().authorities().getFirst().stop(Fence.WINDOW);
    fence.wheels.awaitStopped();
  }

  @Test
  void aSendThatNeverReturnsIsFencedAndTheOtherRobotMovesOn() throws Exception {
    driven("in: send, does: wait_deaf");
    fence.world.awaitAlert(
        "Keira.bad hangs while sending on 'cmd_vel'; nothing more is sent there (bundle org.robotui.tests.bad");
    assertTheGoodOneStillMoves();
    fence.assertTheOthersGoOn();
    String left = fence.close(LIMIT).toString();
    assertTrue(left.contains("threads left: Keira.bad-"), left);
    assertTrue(fence.wheels.commands().getLast().isZero(), "the good one is stopped at the end");
  }

  private void stopWithCall(String settings) throws IOException {
    fence.load("      bad: {type: badrobot, " + settings + "}", DRIVER, "stop_call: {interface: bad, service: /halt}");
    fence.wheels.awaitMoving();
    Eventually.await("the call is there", () -> fence.world.ports().contains("bad.services"), fence.world::ports);
    long now = System.nanoTime();
    fence.keira().authorities().getFirst().stop(Fence.WINDOW);
    long took = fence.wheels.awaitStopped() - now;
    assertTrue(took < 500_000_000L * MachineLoad.factor(), "the zero does not wait for the call, but took " + took);
  }

  @Test
  void anErrorInACallFailsItAtOnce() throws Exception {
    stopWithCall("in: call, does: overflow");
    fence.world
        .awaitAlert("the stop call of Keira failed: the robot interface failed: java.lang.StackOverflowError (bundle "
            + "org.robotui.tests.bad, class ");
    fence.assertTheOthersGoOn();
  }

  @Test
  void aCallThatNeverReturnsRunsIntoItsTimeOut() throws Exception {
    stopWithCall("in: call, does: wait_deaf");
    fence.world.awaitAlert("the stop call of Keira was not answered");
    fence.assertTheOthersGoOn();
  }

  @Test
  void demandThatNeverReturnsHoldsNobodyElseUp() throws Exception {
    fence.robot("in: demand, does: wait_deaf");
    fence.world.awaitText("none", "bad.log");
    fence.assertTheOthersGoOn();
    fence.keira().restart("pulse");
    fence.assertTheOthersGoOn();
    String left = fence.close(LIMIT).toString();
    assertTrue(left.contains("threads left: Keira.bad-"), left);
  }

  @Test
  void demandThatThrowsHoldsNobodyUp() throws Exception {
    fence.robot("in: demand, does: overflow");
    fence.world.awaitText("none", "bad.log");
    fence.keira().restart("pulse");
    fence.assertTheOthersGoOn();
    assertEquals(List.of(), fence.close(LIMIT.multipliedBy(6)));
  }

  @Test
  void dataWithoutEndIsDroppedAndCounted() throws Exception {
    fence.robot("in: publish");
    fence.world.awaitText("none", "bad.log");
    Eventually.await("values are dropped",
        () -> fence.world.port("bad.log").filter(p -> p.count() > 100_000 && p.dropped() > 0).isPresent(),
        () -> fence.world.port("bad.log"));
    fence.assertTheOthersGoOn();
    assertEquals(List.of(), fence.close(LIMIT.multipliedBy(6)));
  }

  @Test
  void aCloseThatThrowsIsToldAtTheEnd() throws Exception {
    fence.robot("in: close, does: assert");
    fence.world.await("bad", RuicState.INITIALIZED);
    String left = fence.close(LIMIT).toString();
    assertTrue(left.contains("bad threw java.lang.AssertionError: an invariant in close (bundle org.robotui.tests.bad"),
        left);
  }

  @Test
  void aCloseThatNeverReturnsIsToldAndTheOtherRobotIsStopped() throws Exception {
    driven("in: close, does: wait_deaf");
    String left = fence.close(LIMIT).toString();
    assertTrue(left.contains("bad did not return from close within "), left);
    assertTrue(left.contains("threads left: Keira.bad-"), left);
    assertTrue(fence.wheels.commands().getLast().isZero());
  }
}
