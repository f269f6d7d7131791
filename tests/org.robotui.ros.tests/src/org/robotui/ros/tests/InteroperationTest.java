package org.robotui.ros.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.net.call.Outcome;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceClient;
import org.robotui.ros.ServiceException;
import org.robotui.ros.ServiceIdentity;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.msgs.StandardServices;

/** Our nodes with rospy and roscpp nodes at a real roscore. */
class InteroperationTest {

  private static final Duration TIME = Duration.ofSeconds(10);

  private RosWorld world;

  @BeforeEach
  void start() throws Exception {
    RosInstallation.assumeThere();
    world = new RosWorld();
    world.roscore();
  }

  @AfterEach
  void stop() throws Exception {
    if (world != null) {
      world.close();
    }
  }

  @Test
  void weHearRospyAndRoscppPublishersOfOneTopic() throws Exception {
    Set<String> heard = ConcurrentHashMap.newKeySet();
    RosNode node = world.node("listener");
    node.subscriber("chatter", RecordCodec.of(StdString.class), SubscriberOptions.standard(),
        (text, reception) -> heard.add(reception.callerId() + " said " + text.data().replaceAll("\\d+", "n")));
    world.python("talker.py", "pythonist", "/chatter");
    world.roscpp("talker", "cplusplus", "/chatter");
    Eventually.await(() -> "both talkers, heard " + heard,
        () -> heard.equals(Set.of("/pythonist said pythonist n", "/cplusplus said cplusplus n")));
  }

  @Test
  void weHearTopicsWhoseNamesRosOnlyWarnsOf() throws Exception {
    Set<String> heard = ConcurrentHashMap.newKeySet();
    world.python("talker.py", "pythonist", "/front-left/chatter");
    world.node("listener").subscriber("/front-left/chatter", RecordCodec.of(StdString.class),
        SubscriberOptions.standard(),
        (text, reception) -> heard.add(reception.callerId()));
    Eventually.await("the talker", () -> heard.contains("/pythonist"));
  }

  @Test
  void weGetLatchedMessagesOfRospy() throws Exception {
    List<String> heard = new CopyOnWriteArrayList<>();
    world.python("latcher.py", "latcher", "/map", "the map");
    world.node("listener").subscriber("map", RecordCodec.of(StdString.class), SubscriberOptions.standard(),
        (text, reception) -> {
          assertTrue(reception.latched());
          heard.add(text.data());
        });
    Eventually.await("the latched message", () -> heard.equals(List.of("the map")));
  }

  @Test
  void rospyAndRoscppHearUs() throws Exception {
    Peer python = world.python("listener.py", "pythonist", "/chatter");
    Peer cplusplus = world.roscpp("listener", "cplusplus", "/chatter");
    Publisher<StdString> publisher =
        world.node("talker").publisher("chatter", RecordCodec.of(StdString.class), PublisherOptions.latched());
    publisher.publish(new StdString("hello"));
    python.awaitLine("/talker hello");
    cplusplus.awaitLine("/talker hello");
    Eventually.await("both links", () -> publisher.numSubscribers() == 2);
    publisher.publish(new StdString("again"));
    python.awaitLine("/talker again");
    cplusplus.awaitLine("/talker again");
  }

  @Test
  void weCallRospyAndRoscppServicesOnceAndPersistently() throws Exception {
    world.python("server.py", "pythonist", "/python_switch");
    world.roscpp("server", "cplusplus", "/cpp_switch");
    RosNode node = world.node("caller");
    for (String service : List.of("/python_switch", "/cpp_switch")) {
      callBothWays(node, service);
    }
  }

  private static void callBothWays(RosNode node, String service) {
    for (boolean persistent : List.of(true, false)) {
      try (ServiceClient<SetBoolRequest, SetBoolResponse> client =
          node.serviceClient(service, StandardServices.SET_BOOL, persistent)) {
        Eventually.await(service, () -> client.call(new SetBoolRequest(true), TIME) instanceof Outcome.Done);
        assertEquals(new Outcome.Done<>(new SetBoolResponse(true, "on by /caller")),
            client.call(new SetBoolRequest(true), TIME));
        Outcome<SetBoolResponse> refused = client.call(new SetBoolRequest(false), TIME);
        assertTrue(refused instanceof Outcome.Refused, service + ": " + refused);
        assertTrue(service.contains("cpp") || refused.reason().contains("it stays on"), refused.reason());
        assertEquals(new Outcome.Done<>(new SetBoolResponse(true, "on by /caller")),
            client.call(new SetBoolRequest(true), TIME));
      }
    }
  }

  @Test
  void weProbeTheTypesOfTheirServices() throws Exception {
    world.python("server.py", "pythonist", "/python_switch");
    world.roscpp("server", "cplusplus", "/cpp_switch");
    RosNode node = world.node("caller");
    String md5 = StandardServices.SET_BOOL.md5();
    Eventually.await("the types", () -> node.probeService("/python_switch", TIME) instanceof Outcome.Done
        && node.probeService("/cpp_switch", TIME) instanceof Outcome.Done);
    assertEquals(new ServiceIdentity("std_srvs/SetBool", md5, "", "", "/pythonist"),
        node.probeService("/python_switch", TIME).toOptional().orElseThrow());
    assertEquals(
        new ServiceIdentity("std_srvs/SetBool", md5, "std_srvs/SetBoolRequest", "std_srvs/SetBoolResponse",
            "/cplusplus"),
        node.probeService("/cpp_switch", TIME).toOptional().orElseThrow());
  }

  @Test
  void rospyAndRoscppCallOurServicePersistently() throws Exception {
    RosNode node = world.node("server");
    node.serviceServer("switch", StandardServices.SET_BOOL, (request, caller) -> {
      if (!request.data()) {
        throw new ServiceException("it stays on");
      }
      return new SetBoolResponse(true, "on by " + caller);
    });
    assertTrue(node.awaitRegistered(TIME));
    Peer python = world.start("/usr/bin/python3", script("caller.py"), "pythonist", "/switch").awaitLine("done");
    assertTrue(python.output().contains("answer True on by /pythonist\nanswer True on by /pythonist\n"),
        python.output());
    assertTrue(python.output().contains("it stays on"), python.output());
    Peer cplusplus = world.roscpp("caller", "cplusplus", "/switch").awaitLine("done");
    assertTrue(cplusplus.output().contains("answer on by /cplusplus\nanswer on by /cplusplus\n"), cplusplus.output());
    assertTrue(cplusplus.output().contains("responded with an error: it stays on"), cplusplus.output());
  }

  private String script(String name) throws Exception {
    return world.resource(name).toString();
  }

  @Test
  void anotherTypeIsRefusedByRoscppAndTheReasonReachesUs() throws Exception {
    List<String> reasons = new CopyOnWriteArrayList<>();
    world.roscpp("talker", "cplusplus", "/chatter");
    world.node("listener", event -> reasons.add(event.toString())).subscriber("chatter",
        RecordCodec.of(org.robotui.message.ros.std_msgs.StdFloat64.class), SubscriberOptions.standard(),
        (number, reception) -> {});
    Eventually.await(() -> "a refusal among " + reasons,
        () -> reasons.stream().anyMatch(reason -> reason.contains("Failed") && reason.contains("/chatter")
            && reason.contains("std_msgs/Float64") && reason.contains("std_msgs/String")));
  }

  @Test
  void parametersSetByOthersReachOurListeners() throws Exception {
    List<String> heard = new CopyOnWriteArrayList<>();
    RosNode node = world.node("watcher");
    node.parameters().set("/limits/speed", XmlRpcValue.of(1.5));
    node.parameters().subscribe("/limits/speed", (key, value) -> heard.add(key + " " + value));
    String first = "/limits/speed Optional[Real[value=1.5]]";
    Eventually.await(() -> "the present value, heard " + heard, () -> heard.equals(List.of(first)));
    world.tool("rosparam", "set", "/limits/speed", "2");
    Eventually.await(() -> "a new value, heard " + heard, () -> heard.contains("/limits/speed Optional[Int[value=2]]"));
    world.tool("rosparam", "set", "/limits", "{speed: 3}");
    Eventually.await(() -> "a value set by its namespace, heard " + heard,
        () -> heard.contains("/limits/speed Optional[Int[value=3]]"));
    world.tool("rosparam", "delete", "/limits/speed");
    Eventually.await(() -> "the deletion, heard " + heard, () -> heard.contains("/limits/speed Optional.empty"));
    assertEquals(new Outcome.Done<>(false), node.parameters().has("/limits/speed"));
  }

  @Test
  void simulatedTimeOfAnotherProcessMayJumpBack() throws Exception {
    List<Long> jumps = new CopyOnWriteArrayList<>();
    RosNode node = world.node("watcher");
    node.clock().onJumpBack((from, to) -> jumps.add(to));
    assertTrue(node.awaitRegistered(TIME));
    Peer clock = world.python("clock.py");
    Eventually.await("simulated time", () -> node.clock().isSimulated() && node.clock().nowNanos() > 100_100_000_000L);
    clock.tell("restart");
    Eventually.await("a jump back", () -> jumps.size() == 1 && jumps.get(0) < 11_000_000_000L);
    Eventually.await("time goes on", () -> node.clock().nowNanos() > 10_100_000_000L);
  }
}
