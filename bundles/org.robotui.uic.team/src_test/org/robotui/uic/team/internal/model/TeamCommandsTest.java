package org.robotui.uic.team.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.command.VelocityCommand;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeRuicView;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.uic.team.internal.Squad;
import org.robotui.uic.team.internal.TeamPorts;

class TeamCommandsTest {
  private final Squad squad = new Squad(3);
  private final TeamCommands commands = new TeamCommands(squad.context);

  @Test
  void aStopReachesThoseWhoAreMeantAndNeedsNoLease() {
    squad.robot(2).take(FakeAuthority.ANNA, false);
    assertEquals("Stopped r1, r2", commands.stop(List.of("r1", "r2")).text());
    assertEquals(Optional.of(FakeAuthority.YOU), squad.robot(2).stoppedBy());
    assertEquals(Optional.empty(), squad.robot(3).stoppedBy());
    assertEquals("Released r2", commands.release(List.of("r2", "r3")).text());
    assertEquals(Optional.of(FakeAuthority.YOU), squad.robot(1).stoppedBy());
    assertEquals("None of them was stopped", commands.release(List.of("r3")).text());
  }

  @Test
  void aZeroIsSentToEachAndTheLeaseIsAskedOfEach() {
    squad.robot(2).take(FakeAuthority.ANNA, false);
    CommandNotice told = commands.zero(List.of("r1", "r2"));
    assertEquals("Velocity zero sent to r1, but not to r2: Anna controls it", told.text());
    assertEquals(Health.BAD, told.health());
    var sent = squad.context.output(TeamPorts.VELOCITY).sent();
    assertEquals(1, sent.size());
    assertEquals(List.of(Squad.source(1, "cmd_vel")), sent.getFirst().targets());
    assertEquals(VelocityCommand.ZERO, sent.getFirst().command());
    assertEquals(Optional.of(FakeAuthority.YOU), squad.robot(1).holder());
    assertEquals(Optional.empty(), squad.robot(3).holder());
  }

  @Test
  void whoTakesNoVelocitySaysSo() {
    squad.context.output(TeamPorts.VELOCITY).targets(List.of(Squad.source(1, "cmd_vel")));
    assertEquals("Not sent: r3: it takes no velocities", commands.zero(List.of("r3")).text());
  }

  @Test
  void opensTheInterfaceOfItsNameOrTheOnlyOneThatHasTheRobot() {
    squad.context.ruics(List.of(squad.context.ruic(), new FakeRuicView(new FakeAuthority("r2"))));
    assertEquals("", commands.open("r2").text());
    assertEquals(List.of("r2"), squad.context.shown());
    assertTrue(commands.open("r1").text().startsWith("r1 has no UI of its own"));
    assertEquals(1, squad.context.shown().size());
  }
}
