package org.robotui.gazebo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.net.call.Outcome;
import org.robotui.web.ArrivalSubscription;

/** Two nodes on loopback, each a process of its own to the other. */
class GazeboNodeTest {
  private static final String TYPE = "ignition.msgs.StringMsg";
  private static final String EMPTY = "ignition.msgs.Empty";
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private final List<GazeboNode> open = new ArrayList<>();
  private final String partition = UUID.randomUUID().toString();
  private final BlockingQueue<String> heard = new LinkedBlockingQueue<>();

  private GazeboNode node() throws IOException {
    return node(Map.of("GZ_PARTITION", partition));
  }

  private GazeboNode node(Map<String, String> variables) throws IOException {
    GazeboNode node = GazeboNode.open(GazeboOptions.of(variables, Thread::new), reason -> {});
    open.add(node);
    return node;
  }

  @AfterEach
  void close() {
    open.forEach(GazeboNode::close);
  }

  private static void await(BooleanSupplier condition) throws InterruptedException {
    long until = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < until, "has not happened");
      Thread.sleep(10);
    }
  }

  private ArrivalSubscription listen(GazeboNode node, String topic) {
    return node.subscribe(topic, TYPE, 100, (sender, payload, nanos) -> heard.add(text(payload)));
  }

  private static String text(ByteBuffer payload) {
    return StandardCharsets.UTF_8.decode(payload).toString();
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private String publishUntilHeard(GazeboPublisher publisher, String text) throws InterruptedException {
    String first = null;
    long until = System.nanoTime() + PATIENCE.toNanos();
    while (first == null && System.nanoTime() < until) {
      publisher.publish(bytes(text));
      first = heard.poll(50, TimeUnit.MILLISECONDS);
    }
    return first;
  }

  @Test
  void messagesReachWhoSubscribes() throws Exception {
    GazeboNode robot = node();
    GazeboPublisher publisher = robot.advertise("/chatter", TYPE);
    GazeboNode node = node();
    await(() -> !node.graph().topics().isEmpty());
    assertEquals("/chatter", node.graph().topics().getFirst().name().name());
    assertEquals(TYPE, node.graph().topics().getFirst().type());
    assertEquals(0, publisher.subscribers());
    ArrivalSubscription subscription = listen(node, "/chatter");
    await(() -> publisher.subscribers() == 1);
    assertEquals("hello", publishUntilHeard(publisher, "hello"));
    subscription.close();
    await(() -> publisher.subscribers() == 0);
  }

  @Test
  void whoSubscribesFirstIsConnectedLater() throws Exception {
    GazeboNode node = node();
    listen(node, "/chatter");
    GazeboPublisher publisher = node().advertise("/chatter", TYPE);
    assertEquals("hello", publishUntilHeard(publisher, "hello"));
    await(() -> publisher.subscribers() == 1);
  }

  @Test
  void whatIsClosedGoesAndComesBack() throws Exception {
    GazeboNode node = node();
    listen(node, "/chatter");
    GazeboNode robot = node();
    robot.advertise("/chatter", TYPE);
    await(() -> node.graph().topics().size() == 1);
    robot.close();
    await(() -> node.graph().topics().isEmpty() && node.graph().processes().isEmpty());
    assertEquals("again", publishUntilHeard(node().advertise("/chatter", TYPE), "again"));
  }

  @Test
  void whatWasPublishedIsSentBeforeTheEnd() throws Exception {
    GazeboNode robot = node();
    GazeboPublisher publisher = robot.advertise("/chatter", TYPE);
    listen(node(), "/chatter");
    publishUntilHeard(publisher, "first");
    heard.clear();
    publisher.publish(bytes("last"));
    robot.close();
    String last = heard.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    while (last != null && last.equals("first")) {
      last = heard.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    }
    assertEquals("last", last);
  }

  @Test
  void otherPartitionsAndStrangersAreNotSeen() throws Exception {
    GazeboNode node = node();
    GazeboNode other = node(Map.of("GZ_PARTITION", "other-" + partition));
    other.advertise("/chatter", TYPE);
    GazeboNode counts = node(Map.of("GZ_PARTITION", partition, "GZ_TRANSPORT_TOPIC_STATISTICS", "1"));
    counts.advertise("/counted", TYPE);
    node().advertise("/mine", TYPE);
    await(() -> !node.graph().topics().isEmpty());
    assertEquals(List.of("/mine"), node.graph().topics().stream().map(each -> each.name().name()).toList());
  }

  @Test
  void countedMessagesAreHeardByThoseWhoCount() throws Exception {
    Map<String, String> counting = Map.of("GZ_PARTITION", partition, "GZ_TRANSPORT_TOPIC_STATISTICS", "1");
    listen(node(counting), "/chatter");
    assertEquals("hello", publishUntilHeard(node(counting).advertise("/chatter", TYPE), "hello"));
  }

  @Test
  void servicesAnswer() throws Exception {
    GazeboNode robot = node();
    robot.serve("/echo", TYPE, TYPE, request -> Optional.of(bytes(text(request) + "!")));
    robot.serve("/fails", TYPE, TYPE, request -> Optional.empty());
    robot.serve("/tell", TYPE, EMPTY, request -> {
      heard.add(text(request));
      return Optional.empty();
    });
    GazeboNode node = node();
    await(() -> node.graph().services().size() == 3);
    assertEquals("hello!", text(ask(node, "/echo").toOptional().orElseThrow()));
    assertEquals("hello!", text(ask(node, "/echo").toOptional().orElseThrow()));
    assertInstanceOf(Outcome.Refused.class, ask(node, "/fails"));
    assertInstanceOf(Outcome.Done.class, ask(node, "/tell"));
    assertEquals("hello", heard.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS));
  }

  private static Outcome<ByteBuffer> ask(GazeboNode node, String name) throws InterruptedException {
    OfferedService service =
        node.graph().services().stream().filter(each -> each.name().name().equals(name)).findFirst().orElseThrow();
    return node.ask(service, bytes("hello"), PATIENCE);
  }

  @Test
  void aServiceThatDoesNotAnswerIsNotWaitedForForEver() throws Exception {
    GazeboNode node = node();
    OfferedService nobody = new OfferedService(new QualifiedName(partition, "/nobody"), TYPE, TYPE,
        "tcp://127.0.0.1:9", "x", "x", "x");
    assertInstanceOf(Outcome.TimedOut.class, node.ask(nobody, bytes("hello"), Duration.ofMillis(200)));
    OfferedService named = new OfferedService(nobody.name(), TYPE, TYPE, "tcp://somewhere.invalid:9", "x", "x", "x");
    assertInstanceOf(Outcome.Failed.class, node.ask(named, bytes("hello"), Duration.ofMillis(200)));
  }

  @Test
  void optionsComeFromTheEnvironment() {
    GazeboOptions given = GazeboOptions.of(Map.of("IGN_PARTITION", "p", "IGN_IP", "10.1.2.3",
        "IGN_DISCOVERY_MULTICAST_IP", "239.1.2.3", "IGN_DISCOVERY_MSG_PORT", "11000", "IGN_DISCOVERY_SRV_PORT", "x"),
        Thread::new);
    assertEquals("p", given.partition());
    assertEquals("10.1.2.3", given.address().getHostAddress());
    assertEquals("239.1.2.3", given.ports().group().getHostAddress());
    assertEquals(List.of(11000, 10318), List.of(given.ports().topics(), given.ports().services()));
    GazeboOptions none = GazeboOptions.of(Map.of(), Thread::new);
    assertEquals(InetAddress.getLoopbackAddress(), none.address());
    assertTrue(none.partition().contains(":"), none.partition());
  }
}
