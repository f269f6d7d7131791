package org.robotui.ros.tests;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.net.call.Outcome;
import org.robotui.ros.LinkEvent;
import org.robotui.ros.LinkState;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceClient;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.msgs.StandardServices;

/** Masters and peers that are killed and come again, in every order. */
class RestartTest {

  private static final Duration TIME = Duration.ofSeconds(10);

  private RosWorld world;
  private final AtomicInteger heard = new AtomicInteger();
  private final List<LinkEvent> events = new CopyOnWriteArrayList<>();

  @BeforeEach
  void start() throws Exception {
    RosInstallation.assumeThere();
    world = new RosWorld();
  }

  @AfterEach
  void stop() throws Exception {
    if (world != null) {
      world.close();
    }
  }

  private RosNode listen() throws Exception {
    RosNode node = world.node("listener", events::add);
    node.subscriber("chatter", RecordCodec.of(StdString.class), SubscriberOptions.standard(),
        (text, reception) -> heard.incrementAndGet());
    return node;
  }

  private void awaitMoreMessages(String when) {
    int before = heard.get();
    Eventually.await(() -> "messages " + when + "; links: " + events, () -> heard.get() > before + 3);
  }

  private void awaitSilence() {
    Eventually.await("a failed link",
        () -> events.stream().anyMatch(
            event -> event.kind() == LinkEvent.Kind.SUBSCRIPTION && event.state() instanceof LinkState.Failed failed
                && failed.reason().contains("/chatter") && failed.reason().contains("/pythonist")));
  }

  @Test
  void theMasterMayComeLast() throws Exception {
    listen();
    world.rosmaster();
    world.python("talker.py", "pythonist", "/chatter");
    awaitMoreMessages("after the master came");
  }

  @Test
  void thePublisherMayDieAndComeAgain() throws Exception {
    world.rosmaster();
    listen();
    Peer talker = world.python("talker.py", "pythonist", "/chatter");
    awaitMoreMessages("at first");
    talker.kill();
    awaitSilence();
    world.python("talker.py", "pythonist", "/chatter");
    awaitMoreMessages("after the publisher came again");
  }

  @Test
  void theMasterMayDieWhileMessagesFlow() throws Exception {
    Peer master = world.rosmaster();
    RosNode node = listen();
    world.python("talker.py", "pythonist", "/chatter");
    awaitMoreMessages("at first");
    master.kill();
    Eventually.await("the loss of the master", () -> events.stream()
        .anyMatch(event -> event.kind() == LinkEvent.Kind.MASTER && event.state() instanceof LinkState.Failed));
    awaitMoreMessages("without a master");
    world.rosmaster();
    Eventually.await("the new master knows us", () -> node.master().systemState().toOptional()
        .map(state -> state.subscribers().getOrDefault("/chatter", List.of()).contains("/listener")).orElse(false));
    awaitMoreMessages("of the publisher that the new master does not know");
  }

  @Test
  void masterAndPublisherMayDieTheMasterFirst() throws Exception {
    Peer master = world.rosmaster();
    listen();
    Peer talker = world.python("talker.py", "pythonist", "/chatter");
    awaitMoreMessages("at first");
    master.kill();
    talker.kill();
    awaitSilence();
    world.rosmaster();
    world.python("talker.py", "pythonist", "/chatter");
    awaitMoreMessages("after both came again");
  }

  @Test
  void masterAndPublisherMayDieThePublisherFirst() throws Exception {
    Peer master = world.rosmaster();
    listen();
    Peer talker = world.roscpp("talker", "pythonist", "/chatter");
    awaitMoreMessages("at first");
    talker.kill();
    awaitSilence();
    master.kill();
    Peer orphan = world.start("/usr/bin/python3", world.resource("talker.py").toString(), "pythonist", "/chatter");
    world.rosmaster();
    orphan.awaitLine("ready");
    awaitMoreMessages("after both came again");
  }

  @Test
  void ourPublisherRegistersAgainAtANewMaster() throws Exception {
    Peer master = world.rosmaster();
    Publisher<StdString> publisher = world.node("talker", events::add).publisher("chatter",
        RecordCodec.of(StdString.class), PublisherOptions.latched());
    publisher.publish(new StdString("the map"));
    world.python("listener.py", "early", "/chatter").awaitLine("the map");
    master.kill();
    world.rosmaster();
    world.python("listener.py", "late", "/chatter").awaitLine("/talker the map");
  }

  @Test
  void ourServiceAndItsCallersSurviveANewMaster() throws Exception {
    Peer master = world.rosmaster();
    world.node("server").serviceServer("switch", StandardServices.SET_BOOL,
        (request, caller) -> new SetBoolResponse(true, caller));
    RosNode caller = world.node("caller");
    try (ServiceClient<SetBoolRequest, SetBoolResponse> client =
        caller.serviceClient("switch", StandardServices.SET_BOOL, false)) {
      Eventually.await("an answer", () -> client.call(new SetBoolRequest(true), TIME) instanceof Outcome.Done);
      master.kill();
      Outcome<SetBoolResponse> without = client.call(new SetBoolRequest(true), TIME);
      assertTrue(
          without instanceof Outcome.Failed && without.reason().contains("/switch")
              && without.reason().contains("master"),
          without.toString());
      world.rosmaster();
      Eventually.await("an answer again", () -> client.call(new SetBoolRequest(true), TIME) instanceof Outcome.Done);
    }
  }

  @Test
  void aPersistentCallerFindsARestartedServer() throws Exception {
    world.rosmaster();
    Peer server = world.python("server.py", "pythonist", "/switch");
    RosNode caller = world.node("caller");
    try (ServiceClient<SetBoolRequest, SetBoolResponse> client =
        caller.serviceClient("switch", StandardServices.SET_BOOL, true)) {
      Eventually.await("an answer", () -> client.call(new SetBoolRequest(true), TIME) instanceof Outcome.Done);
      server.kill();
      Eventually.await("no answer", () -> client.call(new SetBoolRequest(true), TIME) instanceof Outcome.Failed);
      world.python("server.py", "pythonist", "/switch");
      Eventually.await("an answer again", () -> client.call(new SetBoolRequest(true), TIME) instanceof Outcome.Done);
    }
  }

  @Test
  void rospyKeepsHearingUsWhenOurMasterComesAgain() throws Exception {
    org.robotui.ros.master.RosMaster master = world.ourMaster();
    Publisher<StdString> publisher =
        world.node("talker").publisher("chatter", RecordCodec.of(StdString.class), PublisherOptions.latched());
    publisher.publish(new StdString("one"));
    Peer listener = world.python("listener.py", "pythonist", "/chatter").awaitLine("one");
    master.close();
    world.ourMaster();
    publisher.publish(new StdString("two"));
    listener.awaitLine("two");
    world.python("listener.py", "late", "/chatter").awaitLine("two");
  }
}
