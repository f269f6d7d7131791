package org.robotui.uic.topics.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.InputState;
import org.robotui.data.command.MessageCommand;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeOutput;
import org.robotui.ui.Health;

class SpeakerTest {
  private static final long MILLI = 1_000_000;
  private static final MessageCommand HELLO =
      new MessageCommand("/chatter", "std_msgs/String", Map.of("data", "hello"));

  private final FakeAuthority authority = new FakeAuthority("Keira");
  private final FakeOutput<MessageCommand> output = new FakeOutput<>(authority);
  private final Speaker speaker = new Speaker(output, FakeAuthority.YOU);
  private long now = System.nanoTime();

  @Test
  void oneMessageTakesTheFreeLeaseAndIsSaidOnce() {
    speaker.once(HELLO);
    run(1000);
    assertEquals(1, output.sent().size());
    assertEquals(Optional.of(FakeAuthority.YOU), authority.holder());
    assertEquals("Published on /chatter", speaker.look().outcome());
  }

  @Test
  void aLeaseOfSomebodyElseIsTakenOnlyWhenConfirmed() {
    authority.take(FakeAuthority.ANNA, false);
    speaker.once(HELLO);
    assertTrue(speaker.look().asking());
    assertInstanceOf(Speech.Lease.Other.class, speaker.look().lease());
    assertEquals(0, output.sent().size());
    speaker.takeOver();
    assertEquals(0, output.sent().size(), "taking over says nothing by itself");
    speaker.once(HELLO);
    assertEquals(1, output.sent().size());
  }

  @Test
  void aRepetitionKeepsItsRate() {
    speaker.repeat(HELLO, 10, now);
    run(2000);
    assertEquals(20, output.sent().size(), 1);
    assertEquals(Optional.of(10.0), speaker.look().hertz());
  }

  @Test
  void itEndsWhenNobodyLooksAnyMore() {
    speaker.repeat(HELLO, 10, now);
    run(500);
    for (int i = 0; i < 100; i++) {
      now += 20 * MILLI;
      speaker.tick(now);
    }
    assertTrue(speaker.look().hertz().isEmpty());
    assertTrue(output.sent().size() <= 17, "a second later at most, said " + output.sent().size());
    assertTrue(speaker.look().outcome().contains("lost the focus"), speaker.look().outcome());
  }

  @Test
  void itEndsWhenTheLeaseIsLost() {
    speaker.repeat(HELLO, 10, now);
    run(500);
    authority.take(FakeAuthority.ANNA, true);
    int before = output.sent().size();
    run(500);
    assertEquals(before, output.sent().size());
    assertTrue(speaker.look().outcome().contains("Anna has control of Keira"), speaker.look().outcome());
  }

  @Test
  void itEndsWhenTheRobotIsStopped() {
    speaker.repeat(HELLO, 10, now);
    authority.stop(FakeAuthority.ANNA);
    int before = output.sent().size();
    run(500);
    assertEquals(before, output.sent().size());
  }

  @Test
  void aRefusalEndsItAndIsShown() {
    output.outcome(() -> new CommandOutcome.Refused(CommandOutcome.Why.ROBOT, "nobody subscribes to /chatter"));
    speaker.repeat(HELLO, 10, now);
    run(500);
    assertEquals(1, output.sent().size());
    assertEquals("Not published: nobody subscribes to /chatter", speaker.look().outcome());
    assertEquals(Health.BAD, speaker.look().health());
  }

  @Test
  void aLateTickSaysOneMessageNotAll() {
    speaker.repeat(HELLO, 50, now);
    now += 900 * MILLI;
    speaker.tick(now);
    assertEquals(2, output.sent().size());
  }

  @Test
  void whatIsChangedIsSaidFromThenOn() {
    speaker.repeat(HELLO, 10, now);
    speaker.change(new MessageCommand("/chatter", "std_msgs/String", Map.of("data", "bye")));
    run(200);
    assertEquals("bye", output.sent().getLast().command().fields().get("data"));
  }

  @Test
  void whereMessagesGoIsCompared() {
    assertEquals(Optional.empty(), speaker.obstacle("base"));
    assertEquals(Optional.of("messages of this view go to base, not to arm"), speaker.obstacle("arm"));
    output.state(new InputState.Unconnected("base takes no MessageCommand"));
    assertEquals(Optional.of("base takes no MessageCommand"), speaker.obstacle("base"));
  }

  private void run(int millis) {
    for (int i = 0; i < millis / 20; i++) {
      now += 20 * MILLI;
      speaker.watched(now);
      speaker.tick(now);
    }
  }
}
