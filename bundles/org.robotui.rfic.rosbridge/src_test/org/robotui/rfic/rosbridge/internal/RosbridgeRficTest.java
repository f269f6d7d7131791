package org.robotui.rfic.rosbridge.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
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
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.ServiceGrant;
import org.robotui.api.port.ServiceOffer;
import org.robotui.api.port.ServiceReply;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.message.Generation;
import org.robotui.testkit.FakeRficContext;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

class RosbridgeRficTest {
  private static final long PATIENCE_NANOS = 60_000_000_000L;

  private final FakeRficContext context = new FakeRficContext();
  private final AtomicInteger calls = new AtomicInteger();
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
    server.settings.values.put("speed", Map.of("type", 3, "double_value", 0.5));
    Browser browser = context.browsers.get("graph");
    assertEquals(List.of("/base/speed"),
        browser.list(Browser.Kind.PARAMETER).stream().map(Browser.Item::name).toList());
    assertEquals(Optional.of(0.5), browser.parameter("/base/speed"));
    browser.setParameter("/base/speed", 1L);
    assertEquals(Optional.of(1.0), browser.parameter("/base/speed"), "a whole number for a real one");
    assertEquals(Optional.empty(), browser.parameter("/base/none"));
  }

  @Test
  void noQuestionIsAskedThatWouldEndTheRobotsRosapi() throws CallException {
    Browser browser = context.browsers.get("graph");
    for (Browser.Kind kind : List.of(Browser.Kind.TOPIC, Browser.Kind.SERVICE, Browser.Kind.PARAMETER)) {
      for (Browser.Item item : browser.list(kind)) {
        try {
          browser.describe(item);
        } catch (CallException e) {
          assertTrue(e.getMessage().startsWith("odd_srvs/srv/Echo is not known here"), e.getMessage());
        }
      }
    }
    assertFalse(server.rosapiEnded);
  }

  @Test
  void whatIsOfferedIsServedToTheNodesBehindTheBridge() throws Exception {
    await(() -> offered("far/lights").equals("/far/lights (std_srvs/SetBool)"));
    await(() -> "std_srvs/srv/SetBool".equals(server.services.get("/far/lights")));
    assertEquals(Map.of("success", true, "message", "as asked"), response("{\"data\":true}", true));
    assertEquals(Map.of("success", false, "message", "the robot is stopped"), response("{\"data\":false}", false));
    assertEquals(false, response("{\"date\":1}", false).get("success"), "what does not fit is refused");
    assertTrue(offered("echo").contains("/echo is offered already, by a node of the robot"));
    rfic.close();
    await(() -> server.services.isEmpty());
  }

  /** The offer is made again meanwhile, however slow the machine is; the call may so be answered more than once. */
  private Map<String, Object> response(String arguments, boolean result) throws TreeException {
    String id = "call:" + calls.incrementAndGet();
    await(() -> {
      offered("far/lights");
      server.tell(
          "{\"op\":\"call_service\",\"id\":\"" + id + "\",\"service\":\"/far/lights\",\"args\":" + arguments + "}");
      return answerOf(id).isPresent();
    });
    Map<String, Object> response = answerOf(id).orElseThrow();
    assertEquals(result, response.get("result"));
    return Trees.object(response.get("values"));
  }

  private Optional<Map<String, Object>> answerOf(String id) {
    return server.responses.stream().filter(response -> id.equals(response.get("id"))).findFirst();
  }

  @SuppressWarnings("unchecked") // handlers are kept by the names of their ports
  private String offered(String service) {
    await(() -> context.handlers.containsKey("serve"));
    try {
      ServiceGrant grant = ((CallHandler<ServiceOffer, ServiceGrant>) context.handlers.get("serve"))
          .handle(new Asked(new ServiceOffer(service, "std_srvs/SetBool", RosbridgeRficTest::answer)));
      return grant.name() + " (" + grant.type() + ")";
    } catch (CallException e) {
      return e.getMessage();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private static CompletionStage<CallOutcome<ServiceReply>> answer(DynamicRecord request, String caller) {
    return CompletableFuture.completedStage(request.field("data").equals(Optional.of(new FieldValue.Flag(true)))
        ? new CallOutcome.Replied<>(new ServiceReply(new MapRecord("far",
            Map.of("success", new FieldValue.Flag(true), "message", new FieldValue.Text("as asked")))))
        : new CallOutcome.Failed<>("the robot is stopped"));
  }

  private record Asked(ServiceOffer request) implements CallHandler.Invocation<ServiceOffer> {
    @Override
    public long deadlineNanos() {
      return System.nanoTime() + PATIENCE_NANOS;
    }

    @Override
    public void progress(double fraction, String message) {
      // an offer has no progress
    }

    @Override
    public void feedback(DynamicRecord record) {
      // nor feedback
    }
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
