package org.robotui.uic.postures.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.PluginRequest.Verb;
import org.robotui.data.control.ControlPlugins.State;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeCaller;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.uic.postures.internal.model.PostureLine.Standing;
import org.robotui.uic.postures.internal.model.PosturesLook;
import org.robotui.uic.postures.internal.model.PosturesModel;

class PosturesPlayTest {
  private static final long TICK = 50_000_000L;

  private final FakeUicContext context = new FakeUicContext("postures", new PosturesType().schema());
  private final FakeCaller<PluginRequest, PluginReply> caller = new FakeCaller<>(ArmNow.VERBS);
  private final ArmNow arm = new ArmNow(context);
  private PosturesUic uic;
  private PosturesModel model;
  private int answered;
  private long now = 1;

  @BeforeEach
  void store() {
    context.caller(PosturesPorts.VERBS, caller);
    uic = new PosturesUic(context);
    model = uic.model();
    arm.plugin(State.RUNNING, "holding");
    for (double shoulder : new double[]{0, 0.5}) {
      arm.at(shoulder, -shoulder);
      tick(1);
      model.store();
    }
    arm.at(0.2, 0);
    tick(1);
  }

  private void tick(int times) {
    for (int i = 0; i < times; i++) {
      uic.tick(now += TICK);
    }
  }

  private PosturesLook look() {
    model.fresh();
    return model.look();
  }

  /** Answers all that is asked, also what is asked then; the words that were said. */
  private List<String> answer(boolean done, String text) {
    int from = answered;
    while (answered < caller.made().size()) {
      caller.made().get(answered++).end().complete(new CallOutcome.Replied<>(new PluginReply(done, text)));
    }
    return caller.made().subList(from, answered).stream().map(FakeCaller.Made::request)
        .map(request -> request.verb() == Verb.COMMAND ? request.words().replaceFirst("^@\\d+ ", "")
            : request.verb() + " " + request.plugin())
        .toList();
  }

  @Test
  void goesThroughAllOneAfterTheOther() {
    model.play(0);

    assertEquals(List.of("begin;joints shoulder elbow;point 3;positions 0 0;velocity 0.3;run"), answer(true, ""));
    tick(1);
    assertEquals(Standing.TARGET, look().lines().getFirst().standing());
    assertEquals("On the way to Posture 1, 1 of 2", look().words());
    arm.plugin(State.RUNNING, "moving");
    tick(2);
    assertTrue(answer(true, "").isEmpty());
    arm.at(0, 0).plugin(State.RUNNING, "done");
    tick(1);
    assertEquals(List.of("begin;joints shoulder elbow;point 3;positions 0.5 -0.5;velocity 0.3;run"), answer(true, ""));
    arm.at(0.3, -0.3);
    tick(1);
    assertTrue(look().playing(), "what is said to be done is another way yet");
    arm.at(0.5, -0.5);
    tick(1);
    assertFalse(look().playing());
    assertEquals(Health.OK, look().health());
    assertEquals("All postures were gone through", look().words());
  }

  @Test
  void aLoopBeginsAgain() {
    context.settings().set(PosturesType.LOOP, true);
    model.play(1);
    answer(true, "");
    arm.at(0.5, -0.5).plugin(State.RUNNING, "done");
    tick(1);
    assertEquals(1, answer(true, "").size());
    assertEquals(Standing.TARGET, look().lines().getFirst().standing());
    assertTrue(look().playing());
  }

  @Test
  void startsThePluginThatFollowsAndStopsThatOfHands() {
    arm.plugins(State.STOPPED, "holding", State.RUNNING);
    tick(1);
    model.goTo(1);
    List<String> said = answer(true, "");
    assertEquals(List.of("STOP " + ArmNow.GUIDE, "START " + ArmNow.PLUGIN), said.subList(0, 2));
    assertEquals(3, said.size());
    tick(2);
    assertTrue(look().playing(), "that it runs is heard of a little later");
    arm.plugin(State.RUNNING, "moving");
    tick(40);
    assertTrue(look().playing());
    arm.plugin(State.STOPPED, "stopped");
    tick(1);
    assertEquals("Posture 2 was not reached: JointTrajectory does not run any more", look().words());
  }

  @Test
  void aPluginThatDoesNotStartIsSaid() {
    arm.plugin(State.STOPPED, "holding");
    tick(1);
    model.play(0);
    answer(false, "Homing runs and owns shoulder: stop it first.");
    assertEquals("Posture 1 was not reached: JointTrajectory: Homing runs and owns shoulder: stop it first.",
        look().words());
    assertEquals(Standing.FAILED, look().lines().getFirst().standing());
  }

  @Test
  void whatThePluginRefusesOrGivesUpIsSaidByItsWords() {
    model.play(0);
    answer(true, "");
    arm.plugin(State.RUNNING, "aborted: elbow is 0.300 from its path");
    tick(1);
    assertEquals("Posture 1 was not reached: aborted: elbow is 0.300 from its path", look().words());
    model.play(0);
    answer(true, "");
    tick(2);
    assertTrue(look().playing(), "it said that before");
    tick(40);
    assertFalse(look().playing(), "and says it still");
  }

  @Test
  void aCommandThatIsNotTakenWaitsForTheReason() {
    model.play(0);
    answer(false, "JointTrajectory did not understand that.");
    arm.plugin(State.RUNNING, "refused: 'elbow' is no joint of this plugin");
    tick(40);
    assertEquals("Posture 1 was not reached: refused: 'elbow' is no joint of this plugin", look().words());
  }

  @Test
  void whatIsHeldUpForAMomentIsSaidAgainAndThenGivenUp() {
    model.play(0);
    caller.made().get(answered++).end().complete(new CallOutcome.Failed<>("the display has not answered for 0.2 s"));
    tick(1);
    assertEquals(answered, caller.made().size());
    tick(10);
    assertEquals(List.of("begin;joints shoulder elbow;point 3;positions 0 0;velocity 0.3;run"), answer(true, ""));
    assertTrue(look().playing());
    model.stop();
    answer(true, "");
    model.play(0);
    for (int i = 0; i < 80; i++) {
      for (; answered < caller.made().size(); answered++) {
        caller.made().get(answered).end().complete(new CallOutcome.Failed<>("the window is busy"));
      }
      tick(1);
    }
    assertEquals("Posture 1 was not reached: the window is busy", look().words());
  }

  @Test
  void nothingGoesOnAfterStopLeaseSilenceOrALookAway() {
    for (Runnable trouble : List.<Runnable>of(() -> context.authority().stop(FakeAuthority.ANNA),
        () -> context.authority().take(FakeAuthority.ANNA, true),
        () -> context.input(PosturesPorts.CONTROL).state(new InputState.Stale(3, "silent")),
        () -> arm.plugin(State.STOPPED, "stopped"),
        () -> now += 10_000_000_000L)) {
      context.authority().releaseStop(FakeAuthority.ANNA);
      context.authority().take(FakeAuthority.YOU, true);
      arm.at(0.2, 0).plugin(State.RUNNING, "moving");
      tick(1);
      model.play(0);
      answer(true, "");
      tick(1);
      assertTrue(look().playing());
      trouble.run();
      tick(1);
      assertFalse(look().playing());
      assertEquals(Health.BAD, look().health(), look().words());
    }
  }

  @Test
  void stopBringsTheJointsToRest() {
    model.play(0);
    answer(true, "");
    model.stop();
    assertEquals(List.of("stop"), answer(true, ""));
    assertEquals("Stopped on the way to Posture 1", look().words());
    tick(5);
    assertFalse(look().playing());
  }

  @Test
  void somebodyElsesControlIsAskedFor() {
    context.authority().take(FakeAuthority.ANNA, true);
    model.play(0);
    assertEquals("Anna", look().question().orElseThrow().holder());
    assertTrue(caller.made().isEmpty());
    model.control().takeOver();
    assertEquals(1, answer(true, "").size());
  }

  @Test
  void jointsAreMovedByHandOnceNothingElseMovesThem() {
    model.guide(true);
    assertEquals(List.of("STOP " + ArmNow.PLUGIN, "START " + ArmNow.GUIDE), answer(true, ""));
    arm.plugins(State.STOPPED, "holding", State.RUNNING);
    tick(1);
    assertEquals(true, look().guiding().orElseThrow());
    model.guide(false);
    assertEquals(List.of("STOP " + ArmNow.GUIDE), answer(true, ""));
  }
}
