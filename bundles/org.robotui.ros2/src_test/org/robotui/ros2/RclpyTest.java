package org.robotui.ros2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.ros.sensor_msgs.BatteryState;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.graph.GraphState;
import org.robotui.ros2.graph.GraphTopic;
import org.robotui.ros2.lifecycle.LifecycleState;
import org.robotui.ros2.lifecycle.LifecycleTransition;
import org.robotui.ros2.lifecycle.Ros2Lifecycle;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterEvent;
import org.robotui.ros2.parameter.Ros2ParameterValue;
import org.robotui.ros2.parameter.Ros2Parameters;

/** With a robot of ROS 2 that is not ours. */
class RclpyTest {

  private static final int DOMAIN = 161 + (int) (ProcessHandle.current().pid() % 10);
  private static final Duration LONG = Duration.ofSeconds(20);
  private static final Ros2Name BASE = Ros2Name.of("/robot/base");
  private static final Ros2ServiceCodec<SetBoolRequest, SetBoolResponse> SET_BOOL =
      Ros2ServiceCodec.of("std_srvs/srv/SetBool", SetBoolRequest.class, SetBoolResponse.class);
  private static final Ros2Codec<StdString> TEXT = Ros2Codec.of(StdString.class);

  private static RclpyRobot robot;
  private Ros2Context context;
  private Ros2Node node;

  @BeforeAll
  static void start() throws Exception {
    assumeTrue(RclpyRobot.python().isPresent(), "rclpy is not installed (ROBOTUI_ROS2_PEERS)");
    robot = new RclpyRobot(DOMAIN);
  }

  @AfterAll
  static void end() throws Exception {
    if (robot != null) {
      robot.close();
    }
  }

  @BeforeEach
  void open() throws Exception {
    context = Ros2Context.open(Ros2Environment.local(DOMAIN), Ros2Options.standard(Executors.defaultThreadFactory()));
    node = context.node("workbench");
  }

  @AfterEach
  void close() {
    context.close();
  }

  @Test
  void aSensorIsHeardThatOffersBestEffort() throws Exception {
    BlockingQueue<BatteryState> heard = new LinkedBlockingQueue<>();
    Ros2Subscriber subscriber = node.subscriber("/robot/battery", Ros2Codec.of(BatteryState.class),
        Ros2SubscriberOptions.observing(), (message, from) -> heard.add(message));
    BatteryState message = heard.poll(20, TimeUnit.SECONDS);
    assertEquals(0.5f, message.percentage());
    assertTrue(message.header().stamp() > 1_600_000_000_000_000_000L);
    robot.await("the node is known", () -> subscriber.publishers().contains(BASE));
    assertEquals(Ros2Subscriber.Unreadable.NONE, subscriber.unreadable());
  }

  @Test
  void whatIsKeptForLateSubscribersComes() throws Exception {
    BlockingQueue<Ros2Reception> heard = new LinkedBlockingQueue<>();
    node.subscriber("/robot/description", TEXT, Ros2SubscriberOptions.observing(), (text, from) -> heard.add(from));
    Ros2Reception reception = heard.poll(20, TimeUnit.SECONDS);
    assertTrue(reception.kept());
    assertEquals(TEXT.hash(), reception.hash());
  }

  /** Fast DDS says every 3 s what it has, and at once only to who asks in the way that it expects. */
  @Test
  void whatIsKeptForLateSubscribersComesSoon() throws Exception {
    long least = Long.MAX_VALUE;
    for (int tries = 0; tries < 3; tries++) {
      long began = System.nanoTime();
      try (Ros2Context late = Ros2Context.open(Ros2Environment.local(DOMAIN),
          Ros2Options.standard(Executors.defaultThreadFactory()))) {
        BlockingQueue<StdString> heard = new LinkedBlockingQueue<>();
        late.node("late").subscriber("/robot/description", TEXT, Ros2SubscriberOptions.observing(),
            (text, from) -> heard.add(text));
        heard.poll(20, TimeUnit.SECONDS);
        robot.await("its node is named", () -> late.graph().state().node(BASE).isPresent());
      }
      least = Math.min(least, System.nanoTime() - began);
    }
    assertTrue(least < TimeUnit.MILLISECONDS.toNanos(1500), least / 1_000_000 + " ms");
  }

  @Test
  void theRobotHearsUs() {
    Ros2Publisher<StdString> words = node.publisher("/words", TEXT, QosProfiles.DEFAULT);
    robot.await("it subscribes", () -> words.numSubscribers() == 1);
    robot.await("it hears", () -> {
      words.publish(new StdString("hello robot"));
      return robot.said().contains("heard hello robot");
    });
    assertTrue(words.awaitSent(LONG));
  }

  @Test
  void servicesAreCalledBothWays() {
    List<String> callers = new CopyOnWriteArrayList<>();
    node.serviceServer("/ours", SET_BOOL, (request, caller) -> {
      callers.add(caller);
      return new SetBoolResponse(request.data(), "at your service");
    });
    Ros2ServiceClient<SetBoolRequest, SetBoolResponse> client = node.serviceClient("/robot/switch", SET_BOOL);
    assertEquals(new Outcome.Done<>(new SetBoolResponse(false, "switched")),
        client.call(new SetBoolRequest(true), LONG));
    assertEquals(new Outcome.Done<>(new SetBoolResponse(true, "switched")),
        client.call(new SetBoolRequest(false), LONG));
    robot.await("it calls us", () -> robot.said().contains("answered True at your service"));
    assertEquals(1, callers.size());
  }

  @Test
  void parametersOfAllTypesAreReadAndSet() throws Exception {
    Ros2Parameters parameters = Ros2Parameters.open(node, BASE, LONG);
    BlockingQueue<Ros2ParameterEvent> events = new LinkedBlockingQueue<>();
    Ros2Parameters.follow(node, events::add);
    List<String> names = List.of("speed", "count", "words", "flags", "bytes", "fixed");
    assertTrue(parameters.names().toOptional().orElseThrow().containsAll(names));
    Map<String, Ros2ParameterValue> values = parameters.get(names).toOptional().orElseThrow();
    assertEquals(new Ros2ParameterValue.OfInteger(3), values.get("count"));
    assertEquals(new Ros2ParameterValue.OfTexts(List.of("a", "b")), values.get("words"));
    assertEquals(new Ros2ParameterValue.OfBools(List.of(true, false)), values.get("flags"));
    assertEquals(new Ros2ParameterValue.OfBytes(ByteBuffer.wrap(new byte[]{1, -1})), values.get("bytes"));
    Ros2ParameterDescriptor speed = parameters.describe(List.of("speed")).toOptional().orElseThrow().get("speed");
    assertEquals(Optional.of(new Ros2ParameterDescriptor.DoubleRange(0, 2, 0.5)), speed.doubles());
    assertEquals(new Outcome.Done<>(true), parameters.set("speed", new Ros2ParameterValue.OfDouble(1.5)));
    robot.await("it says so to all", () -> events.stream().anyMatch(event -> event.node().equals(BASE)
        && new Ros2ParameterValue.OfDouble(1.5).equals(event.values().get("speed"))));
    assertTrue(parameters.set("speed", new Ros2ParameterValue.OfDouble(9)).reason().contains("out of range"));
    assertTrue(parameters.set("fixed", new Ros2ParameterValue.OfText("")).reason().contains("read-only"));
  }

  @Test
  void aLifeCycleIsFollowedAndDriven() {
    try (Ros2Lifecycle arm = Ros2Lifecycle.open(node, Ros2Name.of("/robot/arm"))) {
      assertEquals(new Outcome.Done<>(new LifecycleState(LifecycleState.UNCONFIGURED, "unconfigured")),
          arm.state(LONG));
      LifecycleTransition configure = arm.transitions(LONG).toOptional().orElseThrow().stream()
          .filter(each -> each.label().equals("configure")).findFirst().orElseThrow();
      assertEquals(new Outcome.Done<>(true), arm.change(configure.id(), LONG));
      assertEquals("inactive", arm.state(LONG).toOptional().orElseThrow().label());
      robot.await("the graph shows it",
          () -> Ros2Lifecycle.nodes(context.graph().state()).equals(List.of(arm.node())));
    }
  }

  @Test
  void theGraphIsThatOfTheRobot() {
    robot.await("its nodes", () -> context.graph().state().node(BASE).isPresent()
        && context.graph().state().node(Ros2Name.of("/robot/arm")).isPresent());
    robot.await("whose the topics are", () -> battery().publishers().get(0).node().equals(Optional.of(BASE)));
    assertEquals("[sensor_msgs/msg/BatteryState]", battery().types().toString());
    assertTrue(QosProfiles.sentence(battery().publishers().get(0).qos()).startsWith("best effort, volatile"));
    GraphState graph = context.graph().state();
    assertEquals("std_srvs/srv/SetBool",
        graph.service(Ros2Name.of("/robot/switch")).orElseThrow().type().orElseThrow().toString());
  }

  private GraphTopic battery() {
    return context.graph().state().topic(Ros2Name.of("/robot/battery")).orElseThrow();
  }
}
