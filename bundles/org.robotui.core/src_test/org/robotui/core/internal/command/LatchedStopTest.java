package org.robotui.core.internal.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.command.VelocityCommand;

/** What a latched stop says to which port, and how often. */
class LatchedStopTest {
  private final RobotBench robot = new RobotBench();
  private final List<String> asked = new CopyOnWriteArrayList<>();

  @AfterEach
  void end() {
    robot.close();
  }

  /** A port that notes what it is asked to stop, and answers as told. */
  private CommandTarget<VelocityCommand> port(String name, Sent answer) {
    CommandTarget<VelocityCommand> target =
        robot.target(new CommandPort<>(name, VelocityCommand.class, Arity.MANY, ""), new CommandSink<>() {
          @Override
          public Sent send(VelocityCommand command) {
            return new Sent.Out();
          }

          @Override
          public Sent stop(VelocityCommand zero, boolean ours) {
            asked.add(name + (ours ? " ours" : ""));
            return answer;
          }
        });
    robot.targets.add(target);
    return target;
  }

  private void drive(CommandTarget<VelocityCommand> target) {
    OutputEnd<VelocityCommand> output = new OutputEnd<>(Samples.YOU, () -> robot.arbiter, robot.clock);
    output.connect(List.of(target), "");
    robot.arbiter.take(Samples.YOU, false);
    output.send(Samples.forward(1), Duration.ofMillis(300));
    robot.pass(1000);
    output.connect(List.of(), "");
  }

  private void reconnect() {
    robot.link.report(new LinkState.Failed("cable", Duration.ofSeconds(1)));
    robot.pass(200);
    robot.link.report(new LinkState.Connected("robot"));
    robot.pass(1000);
  }

  @Test
  void aLatchedStopIsSaidOnce() {
    robot.arbiter.stop(Samples.YOU);
    robot.pass(5000);
    assertEquals(1, robot.zeros());
    assertEquals(1, robot.stopCalls.get());
    assertEquals(Optional.of(Samples.YOU), robot.arbiter.stoppedBy());
  }

  @Test
  void itIsSaidAgainAsLongAsTheRobotReportsMotion() {
    robot.arbiter.stop(Samples.YOU);
    robot.pass(1000);
    robot.report(0);
    robot.pass(1000);
    assertEquals(1, robot.zeros(), "it stands");
    for (int i = 0; i < 10; i++) {
      robot.report(0.4); // somebody else drives it
      robot.pass(100);
    }
    assertEquals(11, robot.zeros(), 1);
    long zeros = robot.zeros();
    robot.arbiter.releaseStop(Samples.YOU);
    robot.report(0.4);
    robot.pass(1000);
    assertEquals(zeros, robot.zeros(), "a stop that was released says nothing");
  }

  @Test
  void whoPressesAgainIsHeardAgain() {
    robot.arbiter.stop(Samples.YOU);
    robot.pass(1000);
    robot.arbiter.stop(Samples.YOU);
    robot.pass(1000);
    assertEquals(2, robot.zeros());
  }

  @Test
  void whatWeMoveGetsTheZerosOfEveryEnd() {
    OutputEnd<VelocityCommand> output = new OutputEnd<>(Samples.YOU, () -> robot.arbiter, robot.clock);
    output.connect(List.of(robot.velocity), "");
    robot.arbiter.take(Samples.YOU, false);
    output.send(Samples.forward(1), Duration.ofSeconds(10));
    robot.awaitSent(1);
    robot.arbiter.stop(Samples.YOU);
    robot.pass(5000);
    assertTrue(robot.zeros() >= 3 && robot.zeros() <= 4, "one datagram may be lost: " + robot.sent);
    assertEquals(VelocityCommand.ZERO, robot.sent.getLast());
  }

  @Test
  void portsAreToldWhetherWeDroveThere() {
    CommandTarget<VelocityCommand> arm = port("arm", new Sent.Out());
    port("other", new Sent.Out());
    drive(arm);
    robot.arbiter.stop(Samples.YOU);
    robot.pass(500);
    assertEquals(List.of("arm ours", "other"), asked.stream().sorted().toList());
  }

  @Test
  void overAReconnectionTheStopIsSaidWhereWeDrove() {
    drive(port("arm", new Sent.Out()));
    port("other", new Sent.Out());
    robot.arbiter.stop(Samples.YOU);
    robot.pass(500);
    asked.clear();
    reconnect();
    assertEquals(List.of("arm ours"), asked);
  }

  @Test
  void whatWasSaidWhileTheLinkWasDownIsSaidWhenItIsUp() {
    port("other", new Sent.Out());
    robot.link.report(new LinkState.Failed("cable", Duration.ofSeconds(1)));
    robot.arbiter.stop(Samples.YOU);
    robot.pass(500);
    asked.clear();
    reconnect();
    assertEquals(List.of("other"), asked);
  }

  @Test
  void aPortThatTheStopDoesNotConcernIsNotAskedAgain() {
    port("position3d", new Sent.Unneeded());
    robot.arbiter.stop(Samples.YOU);
    for (int i = 0; i < 20; i++) {
      robot.report(0.4);
      robot.pass(100);
    }
    assertEquals(List.of("position3d"), asked);
    assertEquals(List.of(), robot.alerts);
  }

  @Test
  void aRefusalIsRememberedAndOnlyToldWhereWeDrove() {
    drive(port("arm", new Sent.Refused("nobody listens")));
    port("other", new Sent.Refused("nobody listens"));
    robot.arbiter.stop(Samples.YOU);
    robot.pass(3050);
    assertEquals(1, asked.stream().filter("other"::equals).count());
    assertTrue(asked.stream().filter("arm ours"::equals).count() > 10, "what we moved is tried again");
    assertEquals(List.of("base.arm: the stop did not get there and is said again: nobody listens"), robot.alerts);
  }

  @Test
  void aPortThatIsMadeAnewWhereWeDroveIsOursStill() {
    CommandTarget<VelocityCommand> before = port("arm", new Sent.Out());
    drive(before);
    robot.arbiter.stop(Samples.YOU);
    robot.pass(500);
    List<String> first = new ArrayList<>(asked);
    robot.targets.remove(before);
    before.close();
    port("arm", new Sent.Out());
    robot.pass(500);
    assertEquals(List.of("arm ours"), first);
    assertEquals(List.of("arm ours", "arm ours"), asked);
  }
}
