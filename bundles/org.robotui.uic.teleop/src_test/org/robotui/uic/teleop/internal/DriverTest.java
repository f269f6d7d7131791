package org.robotui.uic.teleop.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.command.MotionLimits;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeOutput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.uic.teleop.internal.TeleopFooter.Button;

class DriverTest {
  private static final long MS = 1_000_000;

  private final FakeUicContext context = new FakeUicContext("teleop", new TeleopType().schema());
  private final FakeAuthority authority = context.authority();
  private final FakeOutput<VelocityCommand> output = context.output(TeleopType.CMD_VEL);
  private final Driver driver =
      new Driver(output, context.input(TeleopType.ODOM), context.input(TeleopType.NAVIGATION), context.principal(),
          context.settings());

  @Test
  void sendsNothingUntilAHandComes() {
    driver.tick(0);
    assertEquals(List.of(), output.sent());
    assertEquals(0, output.releases());
  }

  @Test
  void theFirstDragTakesAFreeLeaseAndDrives() {
    driver.drag(new Stick(1, 0), 0);
    driver.tick(0);
    assertEquals(Optional.of(FakeAuthority.YOU), authority.holder());
    assertEquals(VelocityCommand.planar(0.05, 0), output.sent().getFirst().command());
    assertEquals(Duration.ofMillis(250), output.sent().getFirst().validFor());
    assertEquals("You control Keira", TeleopFooter.of(driver.look(0)).text());
  }

  @Test
  void whileNavigationDrivesToAGoalThatIsSaid() {
    driver.take();
    navigation("feedback", NavigationStatus.State.ACTIVE, 0);
    assertEquals("Navigation drives Keira to a goal, within limits of its own",
        TeleopFooter.of(driver.look(MS)).text());
    assertEquals("You control Keira", TeleopFooter.of(driver.look(2_000 * MS)).text(),
        "it has said nothing for a while");

    navigation("feedback", NavigationStatus.State.ACTIVE, 3_000 * MS);
    navigation("result", NavigationStatus.State.SUCCEEDED, 3_001 * MS);
    assertEquals("You control Keira", TeleopFooter.of(driver.look(3_002 * MS)).text(), "it is there");

    navigation("feedback", NavigationStatus.State.ACTIVE, 4_000 * MS);
    driver.drag(new Stick(1, 0), 4_001 * MS);
    assertEquals("You control Keira", TeleopFooter.of(driver.look(4_002 * MS)).text(), "by hand");
  }

  private void navigation(String port, NavigationStatus.State state, long at) {
    context.input(TeleopType.NAVIGATION).put(new SourceId("base", port), new NavigationStatus("1", state, ""), at,
        Optional.empty());
  }

  @Test
  void rampsToTheLimitsInTheSettings() {
    context.settings().set(TeleopType.MAX_LINEAR, 0.2);
    context.settings().set(TeleopType.MAX_ANGULAR, 0.5);
    driver.press(DriveKey.FORWARD_LEFT, 0);
    for (int i = 0; i < 40; i++) {
      driver.tick(i * 50 * MS);
    }
    assertEquals(VelocityCommand.planar(0.2, 0.5), output.sent().getLast().command());
  }

  @Test
  void theEndOfADragReleasesAtOnceAndOnce() {
    driver.drag(new Stick(1, 0), 0);
    driver.tick(0);
    driver.dragEnd(10 * MS);
    assertEquals(1, output.releases(), "without waiting for a tick");
    driver.tick(50 * MS);
    assertEquals(1, output.releases());
    assertEquals(1, output.sent().size());
  }

  @Test
  void theNextDriveBeginsAtRest() {
    driver.drag(new Stick(1, 0), 0);
    for (int i = 0; i < 10; i++) {
      driver.tick(i * 50 * MS);
    }
    driver.dragEnd(500 * MS);
    driver.drag(new Stick(1, 0), 600 * MS);
    driver.tick(600 * MS);
    assertEquals(VelocityCommand.planar(0.05, 0), output.sent().getLast().command());
  }

  @Test
  void aKeyReleaseStopsAfterTheGraceWithoutATick() {
    driver.press(DriveKey.FORWARD, 0);
    driver.tick(0);
    driver.release(DriveKey.FORWARD, 10 * MS);
    assertEquals(0, output.releases());
    driver.settle(10 * MS + TeleopModel.GRACE_NANOS);
    assertEquals(1, output.releases());
  }

  @Test
  void lostFocusReleases() {
    driver.press(DriveKey.FORWARD, 0);
    driver.tick(0);
    driver.forget();
    assertEquals(1, output.releases());
    driver.tick(50 * MS);
    assertEquals(1, output.sent().size());
  }

  @Test
  void escapeReleasesThoughTheKeyIsDown() {
    driver.press(DriveKey.FORWARD, 0);
    driver.tick(0);
    driver.letGo();
    driver.press(DriveKey.FORWARD, 20 * MS);
    driver.tick(50 * MS);
    assertEquals(1, output.sent().size());
    assertEquals(1, output.releases());
  }

  @Test
  void spaceLatchesTheStopAndNothingMovesUntilItIsReleased() {
    driver.press(DriveKey.FORWARD, 0);
    driver.tick(0);
    driver.stop();
    driver.release(DriveKey.FORWARD, 100 * MS);
    driver.press(DriveKey.FORWARD, 200 * MS);
    driver.tick(200 * MS);
    assertEquals(1, output.sent().size());
    TeleopFooter footer = TeleopFooter.of(driver.look(200 * MS));
    assertEquals("Stopped by You", footer.text());
    assertEquals(List.of(Button.RELEASE_STOP), footer.buttons());
    driver.releaseStop();
    driver.tick(250 * MS);
    assertEquals(1, output.sent().size(), "the release of the stop moves nothing");
    driver.release(DriveKey.FORWARD, 300 * MS);
    driver.press(DriveKey.FORWARD, 400 * MS);
    driver.tick(400 * MS);
    assertEquals(2, output.sent().size());
  }

  @Test
  void aStopByAnotherEndsTheDriveAtTheNextTick() {
    driver.drag(new Stick(1, 0), 0);
    driver.tick(0);
    authority.stop(FakeAuthority.ANNA);
    driver.tick(50 * MS);
    assertEquals(1, output.releases());
    driver.drag(new Stick(1, 0), 60 * MS);
    driver.tick(100 * MS);
    assertEquals(1, output.sent().size());
  }

  @Test
  void whatSomebodyElseDrivesIsOnlyTakenOverWhenConfirmed() {
    authority.take(FakeAuthority.ANNA, false);
    driver.drag(new Stick(1, 0), 0);
    driver.tick(0);
    assertEquals(List.of(), output.sent());
    assertEquals("Anna has control. Take over?", TeleopFooter.of(driver.look(0)).text());
    driver.takeOver();
    assertEquals(Optional.of(FakeAuthority.YOU), authority.holder());
    driver.dragEnd(10 * MS);
    driver.drag(new Stick(1, 0), 20 * MS);
    driver.tick(50 * MS);
    assertEquals(1, output.sent().size());
  }

  @Test
  void theQuestionCanBeDeclined() {
    authority.take(FakeAuthority.ANNA, false);
    driver.take();
    assertTrue(driver.look(0).asking());
    driver.ask(false);
    assertEquals("Anna has control", TeleopFooter.of(driver.look(0)).text());
    assertEquals(Optional.of(FakeAuthority.ANNA), authority.holder());
  }

  @Test
  void aTakeoverByAnotherEndsTheDrive() {
    driver.drag(new Stick(1, 0), 0);
    driver.tick(0);
    authority.take(FakeAuthority.ANNA, true);
    driver.tick(50 * MS);
    assertEquals(1, output.sent().size());
    assertEquals(1, output.releases());
    assertFalse(driver.look(50 * MS).held());
  }

  @Test
  void giveBackEndsTheDriveFirst() {
    driver.drag(new Stick(1, 0), 0);
    driver.tick(0);
    driver.giveBack();
    assertEquals(1, output.releases());
    assertInstanceOf(TeleopViewState.Lease.Free.class, driver.look(0).lease());
  }

  @Test
  void aRefusalIsShownUntilTheNextDrive() {
    output.outcome(() -> new CommandOutcome.Refused(CommandOutcome.Why.LINK_DOWN, "the link to base is down"));
    driver.drag(new Stick(1, 0), 0);
    driver.tick(0);
    assertEquals("Not sent: the link to base is down", TeleopFooter.of(driver.look(0)).text());
    driver.dragEnd(MS);
    assertEquals("You control Keira", TeleopFooter.of(driver.look(0)).text());
  }

  @Test
  void measuredSpeedIsOnlyShownWhileItIsLive() {
    assertEquals(Optional.empty(), driver.look(0).measured());
    context.input(TeleopType.ODOM).put(VelocityCommand.planar(0.21, -0.1));
    assertEquals(Optional.of(new Speed(0.21, -0.1)), driver.look(0).measured());
    context.input(TeleopType.ODOM).state(new InputState.Stale(3, "no more odometry"));
    assertEquals(Optional.empty(), driver.look(0).measured());
  }

  @Test
  void nothingToDriveOffersNoButton() {
    output.state(new InputState.Unconnected("Keira offers no VelocityCommand"));
    assertEquals(List.of(), TeleopFooter.of(driver.look(0)).buttons());
  }

  @Test
  void theNoteSaysWhoDrivesAndHowFast() {
    assertEquals("control: free \u00b7 by hand max 0.40\u00a0m/s", driver.look(0).note());
    driver.take();
    assertEquals("control: you \u00b7 by hand max 0.40\u00a0m/s", driver.look(0).note());
  }

  @Test
  void neverPromisesMoreThanTheRobotMayBeCommanded() {
    authority.limit(new MotionLimits(0.1, 0.2));
    TeleopViewState look = driver.look(0);
    assertEquals(0.1, look.limits().linear());
    assertEquals(0.2, look.limits().angular());
  }

  @Test
  void whoHoldsTheLeaseOfALostRobotDoesNotDriveIt() {
    driver.take();
    assertEquals(Health.OK, TeleopFooter.of(driver.look(0)).health());
    output.state(new InputState.Waiting("base.cmd: no link (retry 4 s)"));
    TeleopFooter footer = TeleopFooter.of(driver.look(0));
    assertEquals(Health.WARNING, footer.health());
    assertEquals("Cannot drive: base.cmd: no link (retry 4 s)", footer.text());
    assertEquals(List.of(Button.RELEASE_CONTROL), footer.buttons());
    output.state(new InputState.Stale(2, "the link is lost"));
    assertEquals("Cannot drive: the link is lost", TeleopFooter.of(driver.look(0)).text());
  }

  @Test
  void theFooterLeavesOutWhatMattersLeastWhereItIsNarrow() {
    TeleopFooter free = TeleopFooter.of(driver.look(0));
    assertEquals("Nobody has control. Drag the stick or hold a key.", free.fitting(text -> true));
    assertEquals("Nobody has control", free.fitting(text -> text.length() < 20));
    assertEquals("Free", free.fitting(text -> false));
    driver.take();
    output.state(new InputState.Stale(2, "the link is lost"));
    assertEquals("Cannot drive: the link is lost", TeleopFooter.of(driver.look(0)).fitting(text -> false),
        "a reason is cut, not left out");
    output.state(new InputState.Waiting("base.cmd: no link (retry 4 s)"));
    assertEquals("Cannot drive", TeleopFooter.of(driver.look(0)).fitting(text -> false),
        "but where it stands above already");
  }
}
