package org.robotui.core.internal.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.CommandOutcome.Refused;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;

class SenderTest {
  private final RobotBench robot = new RobotBench();
  private final CountDownLatch entered = new CountDownLatch(1);
  private final CountDownLatch gate = new CountDownLatch(1);
  private final CommandTarget<NavigationGoal> hanging =
      robot.target(new CommandPort<>("hanging", NavigationGoal.class, Samples.GOAL.arity(), ""), this::hang);

  @AfterEach
  void end() {
    gate.countDown();
    robot.close();
  }

  private CommandSink.Sent hang(NavigationGoal goal) {
    entered.countDown();
    try {
      gate.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return new CommandSink.Sent.Out();
  }

  private void blockSender() throws InterruptedException {
    hanging.post(Samples.goal(0), Long.MAX_VALUE);
    assertTrue(entered.await(5, TimeUnit.SECONDS));
  }

  @Test
  void hangingSinkIsFencedAndTheStopOfOthersGoesOn() throws InterruptedException {
    blockSender();
    robot.arbiter.stop(Samples.YOU);
    robot.arbiter.step();
    assertTrue(robot.sender.check(robot.clock.nanos()).isEmpty(), "a second is allowed");
    robot.clock.advanceMillis(1100);
    String reason = robot.sender.check(robot.clock.nanos()).orElseThrow();
    assertTrue(reason.contains("hangs while sending on 'hanging'"), reason);
    Await.until("the stop goes out", () -> robot.zeros() == 1);
  }

  @Test
  void fencedPortRefusesCommands() throws InterruptedException {
    blockSender();
    robot.clock.advanceMillis(1100);
    robot.sender.check(robot.clock.nanos());
    robot.arbiter.take(Samples.YOU, false);
    OutputEnd<NavigationGoal> output = new OutputEnd<>(Samples.YOU, () -> robot.arbiter, robot.clock);
    output.connect(List.of(hanging), "");
    CommandOutcome outcome = output.send(Samples.goal(1), Duration.ofSeconds(1));
    assertEquals(CommandOutcome.Why.ROBOT, assertInstanceOf(Refused.class, outcome).why());
  }

  @Test
  void stopOvertakesWhatWaitsAndMotionThatWaitedIsNeverSent() throws InterruptedException {
    blockSender();
    robot.goal.post(Samples.goal(1), Long.MAX_VALUE);
    robot.velocity.post(Samples.forward(1), Long.MAX_VALUE);
    robot.velocity.postZero();
    gate.countDown();
    robot.awaitSent(2);
    assertEquals(List.of(VelocityCommand.ZERO, Samples.goal(1)), robot.sent);
  }

  @Test
  void motionThatWasGivenAfterAStopIsSentAfterIt() throws InterruptedException {
    blockSender();
    robot.velocity.postZero();
    robot.velocity.post(Samples.forward(1), Long.MAX_VALUE);
    gate.countDown();
    robot.awaitSent(2);
    assertEquals(List.of(VelocityCommand.ZERO, Samples.forward(1)), robot.sent);
  }

  @Test
  void ofMotionsThatWaitOnlyTheNewestIsSent() throws InterruptedException {
    blockSender();
    robot.velocity.post(Samples.forward(1), Long.MAX_VALUE);
    robot.velocity.post(Samples.forward(2), Long.MAX_VALUE);
    gate.countDown();
    robot.awaitSent(1);
    robot.settle();
    assertEquals(List.of(Samples.forward(2)), robot.sent);
  }

  @Test
  void nothingIsSentAfterItsExpiry() throws InterruptedException {
    blockSender();
    robot.goal.post(Samples.goal(1), robot.clock.nanos() + 50_000_000);
    robot.clock.advanceMillis(100);
    robot.goal.post(Samples.goal(2), robot.clock.nanos() + 50_000_000);
    gate.countDown();
    robot.awaitSent(1);
    robot.settle();
    assertEquals(List.of(Samples.goal(2)), robot.sent);
  }

  @Test
  void nothingIsQueuedAcrossAReconnection() throws InterruptedException {
    blockSender();
    robot.goal.post(Samples.goal(1), Long.MAX_VALUE);
    robot.link.report(new LinkState.Disconnected());
    robot.link.report(new LinkState.Connected("robot"));
    robot.goal.post(Samples.goal(2), Long.MAX_VALUE);
    gate.countDown();
    robot.awaitSent(1);
    robot.settle();
    assertEquals(List.of(Samples.goal(2)), robot.sent);
  }

  @Test
  void afterAWantOfMemoryItGoesOnSending() {
    CommandTarget<NavigationGoal> starved =
        robot.target(new CommandPort<>("starved", NavigationGoal.class, Samples.GOAL.arity(), ""), goal -> {
          throw new OutOfMemoryError("for a test");
        });
    starved.post(Samples.goal(0), Long.MAX_VALUE);
    robot.velocity.postZero();
    Await.until("the stop goes out", () -> robot.zeros() == 1);
  }

  @Test
  void tooManyWaitingGoalsAreRefused() throws InterruptedException {
    blockSender();
    robot.arbiter.take(Samples.YOU, false);
    OutputEnd<NavigationGoal> output = new OutputEnd<>(Samples.YOU, () -> robot.arbiter, robot.clock);
    output.connect(List.of(robot.goal), "");
    for (int i = 0; i < 16; i++) {
      assertEquals(new CommandOutcome.Accepted(), output.send(Samples.goal(i), Duration.ofSeconds(60)));
    }
    assertInstanceOf(Refused.class, output.send(Samples.goal(17), Duration.ofSeconds(60)));
  }
}
