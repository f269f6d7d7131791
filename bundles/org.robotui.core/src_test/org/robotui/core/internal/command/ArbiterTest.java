package org.robotui.core.internal.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.CommandOutcome.Accepted;
import org.robotui.api.command.CommandOutcome.Refused;
import org.robotui.api.command.CommandOutcome.Why;
import org.robotui.api.command.Principal;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.InputState;
import org.robotui.core.internal.config.model.SafetyConfig;
import org.robotui.core.internal.port.Tap;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.command.MotionLimits;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;

class ArbiterTest {
  private static final Duration VALID = Duration.ofMillis(300);
  private static final Principal OTHER = new Principal("other", "Anna", Principal.Kind.TERMINAL);

  private final RobotBench robot = new RobotBench();
  private final OutputEnd<VelocityCommand> output = output(Samples.YOU);
  private final OutputEnd<NavigationGoal> goals = new OutputEnd<>(Samples.YOU, () -> robot.arbiter, robot.clock);

  private OutputEnd<VelocityCommand> output(Principal principal) {
    OutputEnd<VelocityCommand> end = new OutputEnd<>(principal, () -> robot.arbiter, robot.clock);
    end.connect(List.of(robot.velocity), "");
    return end;
  }

  @AfterEach
  void end() {
    robot.close();
  }

  private void drive() {
    robot.arbiter.take(Samples.YOU, false);
    assertEquals(new Accepted(), output.send(Samples.forward(1), VALID));
    robot.awaitSent(1);
  }

  private void assertRefused(Why why, CommandOutcome outcome) {
    assertEquals(why, assertInstanceOf(Refused.class, outcome).why());
  }

  private void assertStoppedWithThreeZeros() {
    robot.pass(300);
    assertEquals(3, robot.zeros());
    assertEquals(VelocityCommand.ZERO, robot.sent.getLast());
  }

  @Test
  void motionThatIsNotRenewedIsEndedWithThreeZeros() {
    drive();
    robot.pass(290);
    assertEquals(List.of(Samples.forward(1)), robot.sent);
    robot.pass(10);
    assertEquals(1, robot.zeros());
    robot.pass(40);
    assertEquals(1, robot.zeros());
    robot.pass(10);
    assertEquals(2, robot.zeros());
    robot.pass(1000);
    assertEquals(3, robot.zeros());
  }

  @Test
  void renewedMotionGoesOn() {
    drive();
    for (int i = 0; i < 10; i++) {
      robot.pass(200);
      output.send(Samples.forward(1), VALID);
    }
    robot.settle();
    assertEquals(0, robot.zeros());
    assertEquals(11, robot.sent.size());
  }

  @Test
  void releaseEndsAMotionAtOnceAndDoesNothingElsewise() {
    output.release();
    robot.pass(200);
    assertEquals(List.of(), robot.sent);
    drive();
    output.release();
    assertStoppedWithThreeZeros();
  }

  @Test
  void commandedZeroIsRepeatedToo() {
    drive();
    output.send(VelocityCommand.ZERO, VALID);
    robot.pass(1000);
    assertTrue(robot.zeros() >= 3 && robot.zeros() <= 4, robot.sent.toString());
    assertFalse(robot.arbiter.drives(robot.velocity));
  }

  @Test
  void nobodyMovesTheRobotWithoutTheLease() {
    assertRefused(Why.NO_LEASE, output.send(Samples.forward(1), VALID));
    robot.arbiter.take(OTHER, false);
    CommandOutcome refused = output.send(Samples.forward(1), VALID);
    assertRefused(Why.NO_LEASE, refused);
    assertTrue(((Refused) refused).explanation().contains("Anna"));
  }

  @Test
  void leaseMayBeUnneededButIsRespected() {
    robot.safety = new SafetyConfig(MotionLimits.NONE, Optional.empty(), false);
    assertEquals(new Accepted(), output.send(Samples.forward(1), VALID));
    robot.arbiter.take(OTHER, false);
    assertRefused(Why.NO_LEASE, output.send(Samples.forward(1), VALID));
  }

  @Test
  void leaseIsTakenOverOnlyOnConfirmationAndEndsWhatTheFormerHolderMoves() {
    drive();
    assertEquals(new LeaseOutcome.HeldBy(Samples.YOU), robot.arbiter.take(OTHER, false));
    assertEquals(new LeaseOutcome.Granted(), robot.arbiter.take(OTHER, true));
    assertEquals(Optional.of(OTHER), robot.arbiter.holder());
    assertRefused(Why.NO_LEASE, output.send(Samples.forward(1), VALID));
    assertStoppedWithThreeZeros();
  }

  @Test
  void givingTheLeaseBackEndsTheMotion() {
    drive();
    robot.arbiter.giveBack(OTHER);
    assertEquals(Optional.of(Samples.YOU), robot.arbiter.holder(), "somebody else's cannot be given back");
    robot.arbiter.giveBack(Samples.YOU);
    assertEquals(Optional.empty(), robot.arbiter.holder());
    assertStoppedWithThreeZeros();
  }

  @Test
  void newHolderDrivesOnWithoutTheZerosOfTheOldOne() {
    drive();
    robot.arbiter.take(OTHER, true);
    assertEquals(new Accepted(), output(OTHER).send(Samples.forward(2), VALID));
    robot.pass(200);
    assertEquals(Samples.forward(2), robot.sent.getLast());
  }

  @Test
  void limitsAreTheStrictestOfAllAndKeepTheDirection() {
    robot.safety = new SafetyConfig(new MotionLimits(0.5, 1), Optional.empty(), true);
    RobotBench second = new RobotBench();
    second.safety = new SafetyConfig(new MotionLimits(2, 0.1), Optional.empty(), true);
    robot.arbiter.register(second);
    drive();
    assertEquals(Samples.forward(0.5), robot.sent.getFirst());
    output.send(VelocityCommand.planar(0, -1), VALID);
    robot.awaitSent(2);
    assertEquals(-0.1, ((VelocityCommand) robot.sent.getLast()).angular().z(), 1e-9);
    second.close();
  }

  @Test
  void tooOldCommandsAreRefused() {
    robot.arbiter.take(Samples.YOU, false);
    assertRefused(Why.EXPIRED, output.send(Samples.forward(1), Duration.ZERO));
    assertRefused(Why.EXPIRED, output.send(Samples.forward(1), Duration.ofMillis(-5)));
  }

  @Test
  void silentDisplayEndsTheMotionOfAWindowAfter200Milliseconds() {
    robot.display.alive();
    robot.arbiter.take(Samples.YOU, false);
    output.send(Samples.forward(1), Duration.ofSeconds(60));
    robot.awaitSent(1);
    assertEquals(robot.clock.nanos() + DisplayWatch.SILENCE_NANOS + 1, robot.arbiter.step(), "it is woken in time");
    robot.pass(200);
    assertEquals(0, robot.zeros());
    assertFalse(robot.display.takeStopped());
    robot.pass(10);
    assertEquals(1, robot.zeros());
    assertTrue(robot.display.takeStopped(), "the user is to be told");
    assertRefused(Why.DISPLAY_SILENT, output.send(Samples.forward(1), VALID));
    robot.display.alive();
    assertEquals(new Accepted(), output.send(Samples.forward(1), VALID));
  }

  @Test
  void silentDisplayDoesNotConcernScripts() {
    robot.display.alive();
    robot.arbiter.take(Samples.SCRIPT, false);
    output(Samples.SCRIPT).send(Samples.forward(1), Duration.ofSeconds(60));
    robot.pass(1000);
    assertEquals(0, robot.zeros());
  }

  @Test
  void applicationWithoutDisplayIsNotSilent() {
    drive();
    robot.clock.advanceMillis(100_000);
    assertEquals(new Accepted(), output.send(Samples.forward(1), VALID));
  }

  @Test
  void lostFocusEndsTheMotion() {
    drive();
    robot.display.focus(false);
    assertRefused(Why.DISPLAY_SILENT, output.send(Samples.forward(1), VALID));
    assertStoppedWithThreeZeros();
  }

  @Test
  void lostLinkEndsTheMotionAndNothingIsReplayedAfterwards() {
    drive();
    robot.link.report(new LinkState.Failed("cable", Duration.ofSeconds(1)));
    assertRefused(Why.LINK_DOWN, output.send(Samples.forward(1), VALID));
    robot.pass(100);
    int tried = robot.sent.size();
    robot.link.report(new LinkState.Connected("robot"));
    robot.pass(1000);
    assertEquals(tried, robot.sent.size());
    assertFalse(robot.arbiter.drives(robot.velocity));
  }

  @Test
  void stopRefusesEverythingAlsoOfTheHolder() {
    drive();
    goals.connect(List.of(robot.goal), "");
    robot.arbiter.stop(OTHER);
    CommandOutcome refused = output.send(Samples.forward(1), VALID);
    assertRefused(Why.STOPPED, refused);
    assertTrue(((Refused) refused).explanation().contains("Anna"));
    assertRefused(Why.STOPPED, goals.send(Samples.goal(1), VALID));
    robot.pass(100);
    assertEquals(VelocityCommand.ZERO, robot.sent.getLast());
  }

  @Test
  void stopReachesPortsThatCameLater() {
    robot.arbiter.stop(Samples.YOU);
    robot.pass(100);
    robot.targets
        .add(robot.target(new CommandPort<>("arm_vel", VelocityCommand.class, Samples.VELOCITY.arity(), ""), c -> {
          robot.alerts.add("arm " + c);
          return new CommandSink.Sent.Out();
        }));
    robot.pass(100);
    assertEquals("arm " + VelocityCommand.ZERO, robot.alerts.getFirst());
  }

  @Test
  void releasedStopDoesNotBringTheMotionBack() {
    drive();
    robot.arbiter.stop(Samples.YOU);
    robot.arbiter.releaseStop(Samples.YOU);
    robot.sent.clear();
    robot.pass(1000);
    assertFalse(robot.sent.contains(Samples.forward(1)));
  }

  @Test
  void goalsAreNoMotionAndAreSentInOrder() {
    robot.arbiter.take(Samples.YOU, false);
    goals.connect(List.of(robot.goal), "");
    goals.send(Samples.goal(1), VALID);
    goals.send(Samples.goal(2), VALID);
    robot.awaitSent(2);
    robot.pass(1000);
    assertEquals(List.of(Samples.goal(1), Samples.goal(2)), robot.sent);
  }

  @Test
  void closingDoesNotTouchWhatWeDoNotMove() {
    assertEquals(List.of(), robot.arbiter.endNow(robot.targets));
    robot.settle();
    assertEquals(0, robot.zeros());
  }

  @Test
  void afterTheZeroOfAnEndNoCommandOfThoseWhoStillDriveIsTaken() {
    drive();
    assertEquals(List.of(robot.velocity), robot.arbiter.endNow(robot.targets));
    assertRefused(Why.NOT_CONNECTED, output.send(Samples.forward(1), VALID));
    robot.settle();
    assertEquals(VelocityCommand.ZERO, robot.sent.getLast());
    assertEquals(1, robot.zeros());
  }

  @Test
  void refusalOfTheRobotIsShown() {
    CommandTarget<VelocityCommand> deaf =
        robot.target(Samples.VELOCITY, c -> new CommandSink.Sent.Refused("motors are off"));
    output.connect(List.of(deaf), "");
    robot.arbiter.take(Samples.YOU, false);
    output.send(Samples.forward(1), VALID);
    Await.until("it is reported", () -> robot.alerts.contains("base.cmd_vel: motors are off"));
    assertTrue(assertInstanceOf(InputState.Failed.class, output.state()).explanation().contains("motors are off"));
    assertEquals("motors are off", deaf.status(robot.clock).problem());
  }

  @Test
  void unconnectedOutputSaysWhy() {
    output.connect(List.of(), "nothing takes VelocityCommand");
    CommandOutcome refused = output.send(Samples.forward(1), VALID);
    assertEquals(new Refused(Why.NOT_CONNECTED, "nothing takes VelocityCommand"), refused);
    assertEquals(new InputState.Unconnected("nothing takes VelocityCommand"), output.state());
    assertEquals("pioneer", output.authority().robot());
  }

  @Test
  void disconnectedOutputEndsWhatItMoved() {
    drive();
    output.connect(List.of(), "");
    assertStoppedWithThreeZeros();
  }

  @Test
  void whatWentOutCanBeTapped() {
    Tap<VelocityCommand> tap = robot.velocity.sent().join();
    drive();
    output.release();
    robot.pass(200);
    assertEquals(VelocityCommand.ZERO, tap.latest().map(e -> e.value()).orElse(Samples.forward(9)));
    assertEquals(4, robot.velocity.status(robot.clock).count());
    tap.close();
  }

  @Test
  void offerThatWasWithdrawnTakesNothing() {
    robot.arbiter.take(Samples.YOU, false);
    robot.velocity.close();
    assertRefused(Why.NOT_CONNECTED, output.send(Samples.forward(1), VALID));
  }
}
