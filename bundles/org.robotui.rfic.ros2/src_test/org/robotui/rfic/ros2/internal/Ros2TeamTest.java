package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.std_msgs.StdFloat64;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.testkit.FakeRficContext;

/** Many interfaces of one process in one domain: others see one participant with a node for each. */
class Ros2TeamTest extends Ros2Case {
  private static final int ROBOTS = 60;

  private final List<FakeRficContext> contexts = new ArrayList<>();
  private final List<Rfic> interfaces = new ArrayList<>();

  private void add(int number) {
    FakeRficContext its = new FakeRficContext();
    Rfic made = rfic(its, Map.of("namespace", "r" + number));
    contexts.add(its);
    interfaces.add(made);
    made.start();
  }

  private long nodes() {
    return robot.context().graph().state().nodes().stream().filter(node -> !node.own()).count();
  }

  private int participants() {
    return robot.context().participant().discovery().participants().size();
  }

  private Ros2Publisher<StdFloat64> values(int number) {
    return robot.publisher("/r" + number + "/value", Ros2Codec.of(StdFloat64.class), QosProfiles.DEFAULT);
  }

  private List<Double> heard(int number) {
    return contexts.get(number).published.get("value").stream().map(Ros2StreamsTest::number).toList();
  }

  private static boolean connected(FakeRficContext its) {
    return its.links.peekLast() instanceof LinkState.Connected;
  }

  @Test
  void sixtyRobotsAreOneParticipant() {
    List<Ros2Publisher<StdFloat64>> values = IntStream.range(0, ROBOTS).mapToObj(this::values).toList();
    IntStream.range(0, ROBOTS).forEach(this::add);
    await(() -> contexts.stream().allMatch(its -> connected(its) && its.streams.containsKey("value")));
    assertEquals(1, participants());
    await(() -> nodes() == ROBOTS);
    contexts.forEach(its -> its.demand("value", true));
    await(() -> values.stream().allMatch(each -> each.numSubscribers() == 1));
    IntStream.range(0, ROBOTS).forEach(i -> values.get(i).publish(new StdFloat64(i)));
    await(() -> contexts.stream().noneMatch(its -> its.published.get("value").isEmpty()));
    IntStream.range(0, ROBOTS).forEach(i -> assertEquals(List.of(i + 0.0), heard(i), "no other robot is heard"));
    interfaces.forEach(Rfic::close);
    await(() -> participants() == 0);
    assertTrue(contexts.stream().allMatch(its -> its.alive().isEmpty()));
  }

  @Test
  void whoCameFirstEndsAloneAlsoWhereItsThreadsAreInterrupted() {
    Ros2Publisher<StdFloat64> first = values(0);
    Ros2Publisher<StdFloat64> second = values(1);
    robot.subscriber("/r0/cmd_vel", Ros2Codec.of(Twist.class), Ros2SubscriberOptions.observing(), (t, from) -> {});
    add(0);
    await(() -> connected(contexts.get(0)));
    add(1);
    contexts.forEach(its -> {
      await(() -> its.streams.containsKey("value"));
      its.demand("value", true);
    });
    await(() -> first.numSubscribers() + second.numSubscribers() == 2 && nodes() == 2);
    Thread.currentThread().interrupt();
    interfaces.get(0).close();
    assertTrue(Thread.interrupted());
    await(() -> nodes() == 1 && first.numSubscribers() == 0);
    await(() -> contexts.get(0).alive().isEmpty());
    assertEquals(1, participants());
    second.publish(new StdFloat64(1));
    await(() -> heard(1).equals(List.of(1.0)));
    assertEquals(List.of(), heard(0));
    add(0);
    await(() -> connected(contexts.get(2)) && nodes() == 2);
    assertEquals(1, participants());
  }

  @Test
  void whoLooksElsewhereIsAnotherParticipant() {
    values(0);
    add(0);
    await(() -> connected(contexts.get(0)));
    FakeRficContext its = new FakeRficContext();
    Rfic far = rfic(its, Map.of("namespace", "r0", "peers", "localhost"));
    far.start();
    await(() -> participants() == 2 && connected(its));
    far.close();
    await(() -> participants() == 1);
    assertTrue(connected(contexts.get(0)));
  }
}
