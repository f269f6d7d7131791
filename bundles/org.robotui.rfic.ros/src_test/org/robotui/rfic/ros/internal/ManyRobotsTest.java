package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.guard.Guards;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.std_msgs.StdFloat64;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.SystemState;
import org.robotui.testkit.FakeRficContext;

/** Fifty interfaces to fifty robots at one master, which are all closed at once, as core does. */
class ManyRobotsTest extends RosRficCase {
  private static final int ROBOTS = 50;
  /** Longer than a node waits for its master at the end. */
  private static final Duration SLOW = Duration.ofMillis(800);
  /** Two seconds are allowed; the rest is for machines that others use as well. One after the other they take 40 s. */
  private static final Duration END = Duration.ofSeconds(30);
  /**
   * Of fifty: those that a master had not heard when their time was over, on such machines; the next start removes
   * them.
   */
  private static final int FEW = 5;
  private static final List<String> VALUES = List.of("odom", "battery", "task", "joints");

  private final SharedMasters masters = new SharedMasters();
  private final List<FakeRficContext> contexts = new ArrayList<>();
  private final List<RosRfic> rfics = new ArrayList<>();
  private SlowLine line;

  @BeforeEach
  void openMany() throws IOException {
    line = new SlowLine(master.uri());
    for (int i = 0; i < ROBOTS; i++) {
      String name = "r" + i;
      robot.publisher("/" + name + "/scan", RecordCodec.of(LaserScan.class), PublisherOptions.standard());
      VALUES.forEach(value -> robot.publisher("/" + name + "/" + value, RecordCodec.of(StdFloat64.class),
          PublisherOptions.standard()));
      List.of("/cmd_vel", "/turn").forEach(command -> robot.subscriber("/" + name + command,
          RecordCodec.of(Twist.class), SubscriberOptions.standard(), (message, reception) -> {}));
      FakeRficContext its = new FakeRficContext();
      contexts.add(its);
      rfics.add(new RosRfic(its, settings(Map.of("master", line.uri(), "namespace", name)), masters, new Guards()));
    }
    robot.publisher("/tf", RecordCodec.of(TFMessage.class), PublisherOptions.standard());
    assertTrue(robot.awaitRegistered(PATIENCE));
    look();
  }

  /** A team's view looks at all of them. */
  private void look() {
    rfics.forEach(RosRfic::start);
    contexts.forEach(c -> {
      await(() -> c.streams.containsKey("scan") && c.streams.keySet().containsAll(VALUES)
          && c.links.getLast() instanceof LinkState.Connected);
      c.demand("scan", true);
      VALUES.forEach(value -> c.demand(value, true));
    });
    await(() -> nodes() == ROBOTS && subscriptions() >= (1 + VALUES.size()) * ROBOTS);
  }

  @AfterEach
  void closeLine() {
    rfics.forEach(RosRfic::close);
    line.close();
  }

  @Test
  void allEndAtOnceAndTheirMasterForgetsThemAll() throws InterruptedException {
    closeAtOnce();
    await(() -> nodes() <= FEW);
  }

  @Test
  void allEndAtOnceAndAMasterThatIsSlowForgetsThemAll() throws InterruptedException {
    line.delay(SLOW);
    closeAtOnce();
    await(() -> nodes() <= FEW);
  }

  private void closeAtOnce() throws InterruptedException {
    CountDownLatch ended = new CountDownLatch(ROBOTS);
    rfics.forEach(each -> DAEMONS.newThread(() -> {
      each.close();
      ended.countDown();
    }).start());
    assertTrue(ended.await(END.toMillis(), TimeUnit.MILLISECONDS),
        ended.getCount() + " of " + ROBOTS + " have not ended in " + END);
    await(() -> contexts.stream().allMatch(c -> c.alive().isEmpty()));
  }

  /** How many of our nodes the master knows. */
  private long nodes() {
    return state().nodes().stream().filter(name -> name.startsWith("/robotui_")).count();
  }

  private long subscriptions() {
    return state().subscribers().values().stream().mapToLong(List::size).sum();
  }

  private SystemState state() {
    return robot.master().systemState().toOptional().orElseThrow();
  }
}
