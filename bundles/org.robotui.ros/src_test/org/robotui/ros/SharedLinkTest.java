package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageInfo;
import org.robotui.message.RawCodec;
import org.robotui.ros.LinkEvent.Kind;

/** Several subscribers of one node to one topic share one link to each publisher. */
class SharedLinkTest {

  private static final TextCodec TEXT = new TextCodec();
  private static final MessageInfo OTHER =
      new MessageInfo("std_msgs/Int32", "da5909fbe378aeaf85e547e830cc1bb7", "int32 data\n");

  private final List<String> texts = new CopyOnWriteArrayList<>();
  private final List<Integer> sizes = new CopyOnWriteArrayList<>();
  private final LinkLog links = new LinkLog();
  private Graph graph;
  private RosNode talker;
  private RosNode node;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    talker = graph.node("talker");
    node = graph.node("listener", links);
  }

  @AfterEach
  void stop() {
    graph.close();
  }

  private Publisher<String> publisher(PublisherOptions options) {
    return talker.publisher("chatter", TEXT, options);
  }

  private Subscriber texts() {
    return node.subscriber("chatter", TEXT, SubscriberOptions.standard(), (text, reception) -> texts.add(text));
  }

  private Subscriber sizes() {
    return node.subscriber("chatter", new RawCodec(), SubscriberOptions.observing(),
        (raw, reception) -> sizes.add(reception.raw().remaining()));
  }

  @Test
  void bothHearByOneLinkAndTheOtherStaysWhenOneGoes() throws Exception {
    Publisher<String> publisher = publisher(PublisherOptions.standard());
    Subscriber first = texts();
    Subscriber second = sizes();
    Eventually.await("a link", () -> first.numPublishers() == 1 && publisher.numSubscribers() == 1);
    assertEquals(1, second.numPublishers());

    publisher.publish("hello");
    Eventually.await("both hear", () -> texts.equals(List.of("hello")) && sizes.equals(List.of(9)));
    first.close();
    publisher.publish("still");
    Eventually.await("the other one hears", () -> sizes.equals(List.of(9, 9)));
    assertEquals(List.of("hello"), texts);
    assertEquals(1, links.connected(Kind.SUBSCRIPTION), "there was one link all the time");
    second.close();
    Eventually.await("no link", () -> publisher.numSubscribers() == 0);
  }

  @Test
  void whoComesLaterGetsTheLatchedMessageOnce() throws Exception {
    Publisher<String> publisher = publisher(PublisherOptions.latched());
    publisher.publish("map");
    texts();
    Eventually.await("the first hears", () -> texts.equals(List.of("map")));

    sizes();
    Eventually.await("the second hears", () -> sizes.equals(List.of(7)));
    publisher.publish("maps");
    Eventually.await("both hear", () -> texts.equals(List.of("map", "maps")) && sizes.equals(List.of(7, 8)));
    assertEquals(1, links.connected(Kind.SUBSCRIPTION));
  }

  @Test
  void oneThatWantsAnotherTypeIsToldSoAndHarmsNoOther() throws Exception {
    Publisher<String> publisher = publisher(PublisherOptions.standard());
    Subscriber right = texts();
    Eventually.await("a link", () -> right.numPublishers() == 1);
    Subscriber wrong = node.subscriber("chatter", new RawCodec(OTHER), SubscriberOptions.observing(), (raw, r) -> {});
    publisher.publish("a");
    publisher.publish("b");
    Eventually.await("both come", () -> texts.equals(List.of("a", "b")) && wrong.unreadable().count() == 2);
    assertTrue(wrong.unreadable().reason().contains("it sends std_msgs/String"), wrong.unreadable()::reason);
    assertEquals(0, wrong.numPublishers());
    assertEquals(1, links.connected(Kind.SUBSCRIPTION));
  }

  @Test
  void oneThatWantsTheRightTypeIsNotHeldUpByAnotherOne() throws Exception {
    publisher(PublisherOptions.latched()).publish("here");
    node.subscriber("chatter", new RawCodec(OTHER), SubscriberOptions.observing(), (raw, r) -> {});
    links.awaitReason(Kind.SUBSCRIPTION, "/chatter", "std_msgs/Int32");
    texts();
    Eventually.await("it hears", () -> texts.equals(List.of("here")));
  }
}
