package org.robotui.ros2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.description.TypeName;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.graph.GraphService;
import org.robotui.ros2.graph.GraphTopic;
import org.robotui.ros2.internal.graph.EntitiesCodec;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Sample;
import org.robotui.rtps.VendorId;

/** Nodes of several contexts in a domain without a network. */
class NodesTest {

  private static final Ros2ServiceCodec<SetBoolRequest, SetBoolResponse> SET_BOOL =
      Ros2ServiceCodec.of("std_srvs/srv/SetBool", SetBoolRequest.class, SetBoolResponse.class);
  private static final Ros2Codec<StdString> TEXT = Ros2Codec.of(StdString.class);

  private final FakeDomain domain = new FakeDomain();

  @AfterEach
  void close() {
    domain.close();
  }

  @Test
  void messagesGoFromNodeToNode() throws Exception {
    Ros2Node talker = domain.context().node("talker");
    Ros2Node listener = domain.context().node("listener");
    BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    Ros2Subscriber subscriber = listener.subscriber("chatter", TEXT, Ros2SubscriberOptions.observing(),
        (text, from) -> heard.add(from.from() + " " + text.data() + " " + from.kept()));
    Ros2Publisher<StdString> publisher = talker.publisher("/chatter", TEXT, QosProfiles.DEFAULT);
    Eventually.await("both know each other", () -> publisher.subscribers().equals(Set.of(Ros2Name.of("/listener")))
        && subscriber.publishers().equals(Set.of(Ros2Name.of("/talker"))));
    publisher.publish(new StdString("hello"));
    assertEquals("/talker hello false", heard.poll(5, TimeUnit.SECONDS));
    assertEquals(1, subscriber.received());
  }

  @Test
  void aContextEndsWhenAllHaveHeardThatItsNodesAreGone() throws Exception {
    Ros2Context leaving = domain.context();
    leaving.node("talker");
    FakeWriter graph = ((FakeParticipant) leaving.participant()).endpoints.stream()
        .filter(FakeWriter.class::isInstance).map(FakeWriter.class::cast)
        .filter(writer -> writer.info().topic().equals("ros_discovery_info")).findFirst().orElseThrow();
    leaving.close();
    Sample last = graph.last().orElseThrow();
    assertEquals(List.of(), EntitiesCodec.decode(last.payload()).entities().nodes());
    assertEquals(last.sequence(), graph.awaited());
  }

  @Test
  void aTypeInAnotherVersionIsNotReadAndThatIsSaid() throws Exception {
    MessageSchema other = MessageSchema.parse("std_msgs/String", "string data\nuint8 more\n", Generation.ROS2);
    Ros2Codec<DynamicMessage> changed = Ros2Codec.of(TEXT.type(), other);
    Ros2Subscriber subscriber = domain.context().node("listener").subscriber("chatter", TEXT,
        Ros2SubscriberOptions.observing(), (text, from) -> {});
    Ros2Publisher<DynamicMessage> publisher =
        domain.context().node("talker").publisher("chatter", changed, QosProfiles.DEFAULT);
    Eventually.await("the node is known", () -> !subscriber.publishers().isEmpty());
    publisher.publish(new DynamicCodec(other).build(Map.of("data", "hello")));
    Eventually.await("it is counted", () -> subscriber.unreadable().count() == 1);
    assertTrue(subscriber.unreadable().reason().matches(
        "/chatter from /talker: its std_msgs/msg/String has the sum \\w{8}, the one expected df668c74: "
            + "the definitions differ.*"),
        subscriber.unreadable().reason());
  }

  @Test
  void whatDoesNotFitIsSaidInASentence() {
    Ros2Node talker = domain.context().node("talker");
    Ros2Publisher<StdString> publisher = talker.publisher("chatter", TEXT, QosProfiles.SENSOR_DATA);
    Ros2Subscriber subscriber = domain.context().node("listener").subscriber("chatter", TEXT,
        Ros2SubscriberOptions.of(QosProfiles.DEFAULT), (text, from) -> {});
    Eventually.await("the node is known", () -> subscriber.mismatches().stream().anyMatch(s -> s.startsWith("/talk")));
    assertEquals(0, publisher.numSubscribers());
    assertTrue(subscriber.mismatches().get(0).startsWith("/talker: "), subscriber.mismatches().toString());
    assertTrue(subscriber.mismatches().get(0).contains("best effort"), subscriber.mismatches().toString());
  }

  @Test
  void servicesAreCalledAndAnswered() {
    for (VendorId server : List.of(VendorId.FAST_DDS, VendorId.CYCLONE_DDS)) {
      try (Ros2Context there = domain.context(server); Ros2Context here = domain.context(server)) {
        there.node("server").serviceServer("switch", SET_BOOL,
            (request, caller) -> new SetBoolResponse(!request.data(), "asked by " + caller));
        Ros2ServiceClient<SetBoolRequest, SetBoolResponse> client =
            here.node("client").serviceClient("switch", SET_BOOL);
        Outcome<SetBoolResponse> first = client.call(new SetBoolRequest(true), Duration.ofSeconds(5));
        assertEquals(new Outcome.Done<>(new SetBoolResponse(false, "asked by /client")), first, server.toString());
      }
    }
  }

  @Test
  void aServiceThatIsNotThereIsSaidSo() {
    Ros2ServiceClient<SetBoolRequest, SetBoolResponse> client =
        domain.context().node("client").serviceClient("~/switch", SET_BOOL);
    Outcome<SetBoolResponse> outcome = client.call(new SetBoolRequest(true), Duration.ofMillis(30));
    assertEquals("service /client/switch has no server of type std_srvs/srv/SetBool", outcome.reason());
    client.close();
    assertInstanceOf(Outcome.Failed.class, client.call(new SetBoolRequest(true), Duration.ofMillis(30)));
  }

  @Test
  void theGraphKnowsWhoHasWhat() {
    Ros2Context robot = domain.context();
    Ros2Node base = robot.node("base");
    base.publisher("odom", TEXT, QosProfiles.DEFAULT);
    robot.node("arm").serviceServer("/arm/enable", SET_BOOL, (request, caller) -> new SetBoolResponse(true, ""));
    Ros2Context here = domain.context();
    Eventually.await("both nodes", () -> here.graph().state().nodes().size() == 2);
    GraphTopic odom = here.graph().state().topic(Ros2Name.of("/odom")).orElseThrow();
    assertEquals(Set.of("std_msgs/msg/String"), odom.types());
    assertEquals(Optional.of(Ros2Name.of("/base")), odom.publishers().get(0).node());
    assertEquals(TEXT.hash(), odom.publishers().get(0).hash());
    GraphService enable = here.graph().state().service(Ros2Name.of("/arm/enable")).orElseThrow();
    assertEquals("std_srvs/srv/SetBool", enable.type().orElseThrow().toString());
    assertEquals(SET_BOOL.request().hash(), enable.requestHash());
    assertInstanceOf(SchemaLookup.Found.class, here.types().service(enable.name()));
    base.close();
    Eventually.await("one is gone", () -> here.graph().state().nodes().size() == 1);
    assertFalse(here.graph().state().topic(Ros2Name.of("/odom")).isPresent());
    robot.close();
    Eventually.await("all are gone", () -> here.graph().state().nodes().isEmpty());
  }

  @Test
  void anUnknownTypeIsSaidToBeUnknownWithWhatWouldHelp() throws Exception {
    TypeName name = TypeName.parse("odd_msgs/msg/Odd").orElseThrow();
    MessageSchema odd = MessageSchema.parse("odd_msgs/Odd", "uint8 odd\n", Generation.ROS2);
    domain.context().node("odd").publisher("odd", Ros2Codec.of(name, odd), QosProfiles.DEFAULT);
    Ros2Context here = domain.context();
    Ros2Name topic = Ros2Name.of("/odd");
    Eventually.await("the node", () -> here.graph().state().topic(topic)
        .filter(t -> t.publishers().get(0).node().isPresent()).isPresent());
    SchemaLookup<Ros2Types.TypedMessage> found = here.types().topic(topic, Duration.ofMillis(50));
    String reason = ((SchemaLookup.Missing<Ros2Types.TypedMessage>) found).reason();
    assertTrue(reason.startsWith("no definition of odd_msgs/msg/Odd is shipped"), reason);
    assertTrue(reason.contains("/odd did not describe it") && reason.contains("Install the package odd_msgs"), reason);
  }

  @Test
  void simulatedTimeIsFollowedWhenAsked() throws Exception {
    Ros2Node node = domain.context().node("n");
    assertTrue(node.clock().nowNanos() > 1_600_000_000_000_000_000L);
    var codec = Ros2Codec.of(org.robotui.message.ros.rosgraph_msgs.Clock.class);
    Ros2Publisher<org.robotui.message.ros.rosgraph_msgs.Clock> clock =
        domain.context().node("sim").publisher("/clock", codec, QosProfiles.CLOCK);
    BlockingQueue<Long> jumps = new LinkedBlockingQueue<>();
    node.clock().simulated(true);
    node.clock().onJumpBack((from, to) -> jumps.add(from - to));
    assertEquals(0, node.clock().nowNanos());
    Eventually.await("heard", () -> clock.numSubscribers() == 1);
    clock.publish(new org.robotui.message.ros.rosgraph_msgs.Clock(5_000));
    clock.publish(new org.robotui.message.ros.rosgraph_msgs.Clock(2_000));
    assertEquals(3_000L, jumps.poll(5, TimeUnit.SECONDS));
    assertEquals(2_000, node.clock().nowNanos());
  }
}
