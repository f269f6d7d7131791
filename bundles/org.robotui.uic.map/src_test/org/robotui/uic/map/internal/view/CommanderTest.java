package org.robotui.uic.map.internal.view;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.InputState;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Commander;
import org.robotui.uic.map.internal.MapOptions;
import org.robotui.uic.map.internal.MapPorts;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

class CommanderTest {
  private static final FrameId MAP = new FrameId("Keira", "map");
  private final FakeUicContext context = new FakeUicContext("map", MapOptions.schema());
  private final Commander commander = new Commander(context, MapPorts.GOAL, MapPorts.INITIAL_POSE);

  @Test
  void aGoalTakesTheFreeLeaseAndIsSent() {
    CommandNotice told = commander.goal(MAP, RigidTransform.planar(2, -1, 0));
    assertEquals(Health.OK, told.health());
    assertEquals(Optional.of(FakeAuthority.YOU), context.authority().holder());
    assertEquals(MAP, context.output(MapPorts.GOAL).sent().getFirst().command().frame());
    assertTrue(told.text().contains("x 2.00  y \u22121.00"), told.text());
  }

  @Test
  void aLeaseOfSomebodyElseIsNotTaken() {
    context.authority().take(FakeAuthority.ANNA, false);
    CommandNotice told = commander.goal(MAP, RigidTransform.IDENTITY);
    assertEquals(new CommandNotice(Health.BAD, "Not sent: Anna controls Keira; take over first"), told);
    assertTrue(context.output(MapPorts.GOAL).sent().isEmpty());
  }

  @Test
  void aRefusalIsPassedOn() {
    context.output(MapPorts.GOAL)
        .outcome(() -> new CommandOutcome.Refused(CommandOutcome.Why.STOPPED, "the stop is latched; release it first"));
    assertEquals("Not sent: the stop is latched; release it first",
        commander.goal(MAP, RigidTransform.IDENTITY).text());
  }

  @Test
  void withoutAConnectionTheReasonIsSaidAndNoLeaseTaken() {
    context.output(MapPorts.GOAL).state(new InputState.Unconnected("base takes no NavigationGoal"));
    assertEquals("Not sent: base takes no NavigationGoal", commander.goal(MAP, RigidTransform.IDENTITY).text());
    assertTrue(context.authority().holder().isEmpty());
  }

  @Test
  void anInitialPoseSaysHowSureAUserCanBe() {
    commander.initialPose(MAP, RigidTransform.planar(1, 1, 0));
    PoseEstimate sent = context.output(MapPorts.INITIAL_POSE).sent().getFirst().command();
    assertEquals(0.25, sent.covariance().get(0), 1e-9);
    assertEquals(0.25, sent.covariance().get(7), 1e-9);
    assertEquals(15, Math.toDegrees(Math.sqrt(sent.covariance().get(35))), 1e-9);
  }
}
