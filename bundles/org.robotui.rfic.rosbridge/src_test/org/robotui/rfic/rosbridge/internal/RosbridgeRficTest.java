package org.robotui.rfic.rosbridge.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.message.Generation;
import org.robotui.testkit.FakeRficContext;

class RosbridgeRficTest {
  private static final long PATIENCE_NANOS = 60_000_000_000L;

  private final FakeRficContext context = new FakeRficContext();
  private RosbridgeServer server;
  private Rfic rfic;

  @BeforeEach
  void begin() throws IOException {
    server = new RosbridgeServer(Generation.ROS2);
    rfic = RosbridgePeer.rfic(context, Map.of("url", "ws://127.0.0.1:" + server.port()));
    rfic.start();
    await(() -> context.links.peekLast() instanceof LinkState.Connected);
  }

  @AfterEach
  void end() {
    rfic.close();
    server.close();
  }

  private static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      LockSupport.parkNanos(5_000_000);
    }
  }

  @Test
  void whatTheBridgeDoesForItsClientsIsNoPort() {
    await(() -> context.streams.keySet().containsAll(List.of("odom", "scan"))
        && context.commands.containsKey("cmd_vel"));
    assertEquals(List.of("cmd_vel"), context.commands.keySet().stream().filter("cmd_vel"::equals).toList());
    assertTrue(!context.streams.containsKey("cmd_vel") && !context.commands.containsKey("odom"));
  }

  @Test
  void whatThereIsIsDescribed() throws CallException {
    Browser browser = context.browsers.get("graph");
    Browser.Item odom = browser.list(Browser.Kind.TOPIC).stream().filter(i -> i.name().equals("/odom")).findFirst()
        .orElseThrow();
    Browser.Description description = browser.describe(odom);
    assertEquals(Map.of("type", "nav_msgs/msg/Odometry", "publishers", "/base", "subscribers", "none"),
        description.facts());
    assertEquals("header", description.shape().orElseThrow().fields().getFirst().name());
    assertEquals(List.of("/base", "/rosbridge_websocket"),
        browser.list(Browser.Kind.NODE).stream().map(Browser.Item::name).toList());
    assertTrue(browser.links().contains(new Browser.Link("/base", "/cmd_vel", false)));
  }

  @Test
  void parametersAreReadAndSet() throws CallException {
    server.parameters.put("/speed", "0.5");
    Browser browser = context.browsers.get("graph");
    assertEquals(Optional.of(0.5), browser.parameter("/speed"));
    browser.setParameter("/speed", List.of(1L, 2L));
    assertEquals(Optional.of(List.of(1L, 2L)), browser.parameter("/speed"));
    assertEquals(Optional.empty(), browser.parameter("/none"));
  }

  private int asked(String question) {
    return Optional.ofNullable(server.asked.get("/rosapi/" + question)).map(AtomicInteger::get).orElse(0);
  }

  /** As often as it is asked which nodes there are, it may be asked about twenty of them; about one in the long run. */
  @Test
  void aBridgeOfManyNodesIsAskedLittleAtATime() throws CallException {
    IntStream.range(0, 100).forEach(i -> server.nodes.add("/other" + i));
    Browser browser = context.browsers.get("graph");
    await(() -> {
      assertTrue(asked("node_details") <= 20 * asked("nodes"));
      return asked("node_details") > 100;
    });
    assertEquals(102, browser.list(Browser.Kind.NODE).size());
    rfic.close();
    int before = asked("node_details");
    assertTrue(before > 100 && before <= 20 * asked("nodes"), () -> server.asked.toString());
  }
}
