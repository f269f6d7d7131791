package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.guard.Guards;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.msgs.geometry_msgs.Twist;
import org.robotui.ros.msgs.sensor_msgs.LaserScan;
import org.robotui.ros.msgs.std_msgs.StdFloat64;
import org.robotui.testkit.FakeRficContext;

/** Fifty interfaces to fifty robots at one master, which are all closed at once, as core does. */
class ManyRobotsTest extends RosRficCase {
  private static final int ROBOTS = 50;
  /** Longer than a node waits for its master at the end. */
  private static final Duration SLOW = Duration.ofMillis(800);
  /** Two seconds are allowed; the rest is for machines that others use as well. */
  private static final Duration END = Duration.ofSeconds(5);
  /** Of a hundred: what had not left when its node's time was over, on such machines; the next start removes it. */
  private static final int FEW = 10;
  private static final Pattern STREAM = Pattern.compile("/r\\d+/(scan|value)");

  private final SharedMasters masters = new SharedMasters();
  private final List<FakeRficContext> contexts = new ArrayList<>();
  private final List<RosRfic> rfics = new ArrayList<>();
  private SlowLine line;

  @BeforeEach
  void openMany() throws IOException {
    line = new SlowLine(master.uri());
    for (int i = 0; i < ROBOTS; i++) {
      String name = "r" + i;
      robot.publisher("/" + name + "/scan", LaserScan.CODEC, PublisherOptions.standard());
      robot.publisher("/" + name + "/value", StdFloat64.CODEC, PublisherOptions.standard());
      robot.subscriber("/" + name + "/cmd_vel", Twist.CODEC, SubscriberOptions.standard(), (message, reception) -> { });
      FakeRficContext its = new FakeRficContext();
      contexts.add(its);
      rfics.add(new RosRfic(its, settings(Map.of("master", line.uri(), "namespace", name)), masters, new Guards()));
    }
    assertTrue(robot.awaitRegistered(PATIENCE));
  }

  @AfterEach
  void closeLine() {
    rfics.forEach(RosRfic::close);
    line.close();
  }

  @Test
  void allEndAtOnceAndAMasterThatIsSlowForgetsThemAll() throws InterruptedException {
    rfics.forEach(RosRfic::start);
    contexts.forEach(c -> {
      await(() -> c.streams.containsKey("scan") && c.streams.containsKey("value") && c.links.getLast() instanceof LinkState.Connected);
      c.demand("scan", true);
      c.demand("value", true);
    });
    await(() -> registered() == 2 * ROBOTS);
    line.delay(SLOW);
    CountDownLatch ended = new CountDownLatch(ROBOTS);
    rfics.forEach(each -> DAEMONS.newThread(() -> {
      each.close();
      ended.countDown();
    }).start());
    assertTrue(ended.await(END.toMillis(), TimeUnit.MILLISECONDS), ended.getCount() + " of " + ROBOTS + " have not ended in " + END);
    await(() -> contexts.stream().allMatch(c -> c.alive().isEmpty()));
    await(() -> registered() <= FEW);
  }

  /** How many interfaces the master has listed at the streams of the robots. */
  private long registered() {
    return robot.master().systemState().toOptional().orElseThrow().subscribers().entrySet().stream()
        .filter(topic -> STREAM.matcher(topic.getKey()).matches()).mapToLong(topic -> topic.getValue().size()).sum();
  }
}
