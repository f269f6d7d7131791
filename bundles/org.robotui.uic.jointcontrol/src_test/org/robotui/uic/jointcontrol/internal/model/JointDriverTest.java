package org.robotui.uic.jointcontrol.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.InputState;
import org.robotui.data.command.MotionLimits;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointControl.Source;
import org.robotui.data.joint.JointMode;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeOutput;
import org.robotui.uic.jointcontrol.internal.Robots;

class JointDriverTest {
  private static final long TICK = 50_000_000L;
  private static final InputState LIVE = new InputState.Live(50, 0.01);
  private static final double SPEED = 0.5;
  private static final double STEP = SPEED * 2.1 * 0.05;
  private static final double MEASURED = -0.72;

  private final FakeAuthority authority = new FakeAuthority("Arm");
  private final FakeOutput<JointCommand> output = new FakeOutput<>(authority);
  private final JointDriver driver = new JointDriver(output, FakeAuthority.YOU, () -> SPEED);
  private long now;

  @BeforeEach
  void see() {
    see(Robots.arm(), LIVE);
  }

  @Test
  void monitorsUntilTheUserHasConfirmed() {
    driver.goal("arm_2", 1);
    tick();
    assertEquals(Phase.MONITOR, driver.look().phase());
    driver.toggle();
    driver.goal("arm_2", 1);
    tick();
    assertEquals(Phase.ASKING, driver.look().phase());
    assertTrue(output.sent().isEmpty());
    assertTrue(authority.holder().isEmpty());
  }

  @Test
  void theQuestionNamesWhatWillMove() {
    driver.toggle();
    String question = JointFooter.of(driver.look()).text();
    assertTrue(question.startsWith("Drive all 9 joints (arm, gripper) of Arm?"), question);
    assertTrue(question.contains("50\u00a0%"), question);
    assertTrue(question.contains("communication"), question);
  }

  @Test
  void confirmingAloneMovesNothing() {
    drive();
    tick();
    tick();
    assertTrue(output.sent().isEmpty());
    assertEquals(Optional.of(FakeAuthority.YOU), authority.holder());
  }

  @Test
  void theTargetStartsAtTheMeasuredPositionAndIsBoundInSpeed() {
    drive();
    driver.goal("arm_2", 1);
    tick();
    JointCommand.Joint first = sent().getFirst();
    assertEquals("arm_2", first.name());
    assertEquals(Set.of(JointMode.POSITION), first.modes());
    assertEquals(MEASURED + STEP, first.reference().position(), 1e-9);
    tick();
    assertEquals(MEASURED + 2 * STEP, sent().getFirst().reference().position(), 1e-9);
    assertEquals(Duration.ofMillis(200), output.sent().getLast().validFor());
    assertEquals(1, sent().size());
  }

  @Test
  void aLateTickDoesNotMakeTheTargetJump() {
    drive();
    driver.goal("arm_2", 2);
    tick();
    now += 5_000_000_000L;
    driver.tick(now);
    assertTrue(sent().getFirst().reference().position() <= MEASURED + 3 * STEP + 1e-9);
  }

  @Test
  void theTargetStopsAtItsGoalAndIsKept() {
    drive();
    driver.goal("arm_2", MEASURED + 1.5 * STEP);
    tick();
    tick();
    tick();
    assertEquals(MEASURED + 1.5 * STEP, sent().getFirst().reference().position(), 1e-9);
  }

  @Test
  void goalsStayWithinTheLimits() {
    drive();
    driver.goal("arm_2", 99);
    assertEquals(2.6, driver.look().aims().get("arm_2").goal());
    driver.nudge("arm_2", -99);
    assertEquals(-2.6, driver.look().aims().get("arm_2").goal());
  }

  @Test
  void theLimitsOfTheRobotBoundTheSpeedToo() {
    authority.limit(new MotionLimits(0.01, 0.1));
    drive();
    driver.goal("arm_2", 1);
    driver.goal("finger", 0.04);
    tick();
    assertEquals(MEASURED + 0.1 * 0.05, sent().getFirst().reference().position(), 1e-9);
    assertEquals(0.0213 + 0.01 * 0.05, sent().getLast().reference().position(), 1e-9);
  }

  @Test
  void aJogEndsWithTheHand() {
    drive();
    driver.jog(true);
    driver.goal("arm_2", 2);
    tick();
    double reached = sent().getFirst().reference().position();
    driver.letGo();
    tick();
    tick();
    assertEquals(reached, sent().getFirst().reference().position(), 1e-12);
  }

  @Test
  void aTargetGoesOnWithoutTheHand() {
    drive();
    driver.goal("arm_2", 2);
    tick();
    driver.letGo();
    tick();
    assertEquals(MEASURED + 2 * STEP, sent().getFirst().reference().position(), 1e-9);
  }

  @Test
  void gainsAreSentWhereTheModeHasThem() {
    drive();
    driver.stiffness("arm_2", 300);
    driver.damping("arm_6", 9);
    tick();
    assertEquals(Set.of(JointMode.POSITION, JointMode.STIFFNESS), sent().getFirst().modes());
    assertEquals(300, sent().getFirst().reference().stiffness());
    assertEquals(Set.of(JointMode.POSITION), sent().getLast().modes());
  }

  @Test
  void aStopEndsDrivingForGood() {
    moving();
    authority.stop(FakeAuthority.ANNA);
    assertEnded("Arm is stopped by Anna");
    driver.releaseStop();
    tick();
    assertEquals(1, output.releases());
    assertEquals(Phase.MONITOR, driver.look().phase());
  }

  @Test
  void aTakeoverEndsDrivingAndSaysByWhom() {
    moving();
    authority.take(FakeAuthority.ANNA, true);
    assertEnded("Anna took control of Arm");
  }

  @Test
  void staleStateEndsDriving() {
    moving();
    see(Robots.arm(), new InputState.Stale(1, "silent"));
    assertEnded("stale");
  }

  @Test
  void aLostLinkEndsDriving() {
    moving();
    output.state(new InputState.Unconnected("the link is down"));
    assertEnded("the link is down");
  }

  @Test
  void aRefusedCommandEndsDriving() {
    moving();
    output.outcome(() -> new CommandOutcome.Refused(CommandOutcome.Why.ROBOT, "somebody else is the master"));
    assertEnded("somebody else is the master");
  }

  @Test
  void lostFocusEndsDriving() {
    moving();
    driver.end("Not driving any more: the view lost the focus");
    assertEnded("focus");
    int count = output.sent().size();
    driver.goal("arm_2", 1);
    tick();
    assertEquals(count, output.sent().size());
  }

  @Test
  void theSwitchGivesControlBack() {
    moving();
    driver.toggle();
    assertEquals(Phase.MONITOR, driver.look().phase());
    assertTrue(authority.holder().isEmpty());
    assertEquals(1, output.releases());
  }

  @Test
  void somebodyElseIsTakenOverOnlyWhenTheUserSaysSo() {
    authority.take(FakeAuthority.ANNA, false);
    driver.toggle();
    assertTrue(JointFooter.of(driver.look()).text().startsWith("Anna has control now. Take over and drive"));
    driver.confirm(false);
    assertEquals(Phase.ASKING, driver.look().phase());
    assertEquals(Optional.of(FakeAuthority.ANNA), authority.holder());
    driver.confirm(true);
    assertTrue(driver.look().driving());
  }

  @Test
  void aJointInItsSafeStateIsNotDriven() {
    see(Robots.troubled(), LIVE);
    drive();
    driver.goal("arm_3", 1);
    driver.goal("arm_6", 1);
    tick();
    assertTrue(output.sent().isEmpty());
    assertTrue(driver.look().told().orElse("").contains("not measured"), driver.look().toString());
  }

  @Test
  void aJointThatFallsIntoItsSafeStateIsGivenUp() {
    moving();
    see(Robots.arm(Source.SAFE, "communication"), LIVE);
    tick();
    assertTrue(driver.look().aims().isEmpty());
    assertTrue(driver.look().told().orElse("").contains("safe state"));
    assertEquals(1, output.releases());
  }

  @Test
  void aJointThatDoesNotListenIsGivenUpWithItsOwner() {
    see(Robots.arm(Source.FREE, ""), LIVE);
    drive();
    driver.goal("arm_2", 1);
    for (int i = 0; i < 25; i++) {
      tick();
    }
    assertTrue(driver.look().aims().isEmpty());
    assertTrue(driver.look().told().orElse("").contains("no plugin owns it"), driver.look().told().toString());
    see(Robots.arm(Source.COMMANDED, "homing"), LIVE);
    driver.goal("arm_2", 1);
    for (int i = 0; i < 40; i++) {
      tick();
    }
    assertTrue(driver.look().told().orElse("").contains("homing owns it"), driver.look().told().toString());
  }

  @Test
  void aJointThatListensIsKept() {
    drive();
    driver.goal("arm_2", 1);
    for (int i = 0; i < 60; i++) {
      tick();
      see(following(), LIVE);
    }
    assertEquals(1, driver.look().aims().get("arm_2").target(), 1e-9);
    assertTrue(driver.look().told().isEmpty());
  }

  @Test
  void withoutAModelNothingCanBeDriven() {
    driver.see(Joints.of(Optional.empty(), Robots.arm()), LIVE);
    driver.toggle();
    assertEquals(Phase.MONITOR, driver.look().phase());
    assertEquals("Cannot drive: the limits of the joints are not known", JointFooter.of(driver.look()).text());
  }

  @Test
  void aStaleStateWhileAskedEndsTheQuestion() {
    driver.toggle();
    see(Robots.arm(), new InputState.Stale(1, "silent"));
    tick();
    assertEquals(Phase.MONITOR, driver.look().phase());
    assertTrue(JointFooter.of(driver.look()).text().startsWith("Cannot drive"));
    driver.confirm(true);
    assertFalse(driver.look().driving());
  }

  private JointControl following() {
    List<JointControl.Joint> joints = new ArrayList<>(Robots.arm().joints());
    double target = sent().getFirst().reference().position();
    joints.set(1, Robots.joint("arm_2", target, target, 0, 0, Robots.POSITION, Source.COMMANDED, "communication"));
    return new JointControl(joints);
  }

  private void assertEnded(String why) {
    tick();
    assertEquals(Phase.MONITOR, driver.look().phase());
    assertTrue(driver.look().told().orElse("").contains(why), driver.look().told().toString());
    assertTrue(driver.look().aims().isEmpty());
    assertEquals(1, output.releases());
  }

  private void moving() {
    drive();
    driver.goal("arm_2", 1);
    tick();
    assertEquals(1, output.sent().size());
  }

  private void drive() {
    driver.toggle();
    driver.confirm(false);
    assertTrue(driver.look().driving());
  }

  private void see(JointControl control, InputState state) {
    driver.see(Joints.of(Optional.of(Robots.armModel()), control), state);
  }

  private void tick() {
    now += TICK;
    driver.tick(now);
  }

  private List<JointCommand.Joint> sent() {
    return output.sent().getLast().command().joints();
  }
}
