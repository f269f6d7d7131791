package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageInfo;
import org.robotui.message.RawCodec;
import org.robotui.ros.LinkEvent.Kind;

class PubSubTest {

  private static final TextCodec TEXT = new TextCodec();

  private Graph graph;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
  }

  @AfterEach
  void stop() {
    graph.close();
  }

  private static Subscriber listen(RosNode node, String topic, List<String> into) {
    return node.subscriber(topic, TEXT, SubscriberOptions.standard(), (text, reception) -> into.add(text));
  }

  @Test
  void aMessageReachesASubscriberOfAnotherNode() throws Exception {
    List<Reception> receptions = new CopyOnWriteArrayList<>();
    RosNode talker = graph.node("talker");
    RosNode listener = graph.node("listener");
    Publisher<String> publisher = talker.publisher("chatter", TEXT, PublisherOptions.standard());
    Subscriber subscriber = listener.subscriber("/chatter", TEXT, SubscriberOptions.standard(),
        (text, reception) -> receptions.add(reception));
    Eventually.await("a subscriber", () -> publisher.numSubscribers() == 1 && subscriber.numPublishers() == 1);
    publisher.publish("hello");
    Eventually.await("the message", () -> receptions.size() == 1);
    assertEquals("/talker", receptions.get(0).callerId());
    assertEquals("std_msgs/String", receptions.get(0).peer().type());
    assertEquals("string data\n", receptions.get(0).peer().definition());
    assertEquals(9, receptions.get(0).raw().remaining());
    assertEquals(1, subscriber.received());
  }

  @Test
  void manyMessagesArriveInOrderWithoutLoss() throws Exception {
    List<String> got = new CopyOnWriteArrayList<>();
    Publisher<String> publisher =
        graph.node("talker").publisher("chatter", TEXT, PublisherOptions.standard().withQueue(100_000));
    listen(graph.node("listener"), "chatter", got);
    Eventually.await("a subscriber", () -> publisher.numSubscribers() == 1);
    List<String> sent = java.util.stream.IntStream.range(0, 5_000).mapToObj(Integer::toString).toList();
    sent.forEach(publisher::publish);
    Eventually.await("all messages", () -> got.size() == sent.size());
    assertEquals(sent, got);
    assertEquals(0, publisher.dropped());
  }

  @Test
  void severalMebibytesArriveUnchanged() throws Exception {
    List<String> got = new CopyOnWriteArrayList<>();
    Publisher<String> publisher = graph.node("talker").publisher("chatter", TEXT, PublisherOptions.standard());
    listen(graph.node("listener"), "chatter", got);
    Eventually.await("a subscriber", () -> publisher.numSubscribers() == 1);
    String large = "abcdefgh".repeat(700_000);
    publisher.publish(large);
    publisher.publish("after");
    Eventually.await("both", () -> got.size() == 2);
    assertEquals(List.of(large, "after"), got);
  }

  @Test
  void aLateSubscriberGetsTheLatchedMessage() throws Exception {
    List<String> got = new CopyOnWriteArrayList<>();
    Publisher<String> publisher = graph.node("talker").publisher("map", TEXT, PublisherOptions.latched());
    publisher.publish("old");
    publisher.publish("map");
    listen(graph.node("listener"), "map", got);
    Eventually.await("the latched message", () -> got.equals(List.of("map")));
  }

  @Test
  void aLateSubscriberGetsTheLatchedMessageOfEachSender() throws Exception {
    List<String> got = new CopyOnWriteArrayList<>();
    Publisher<String> publisher = graph.node("talker").publisher("map", TEXT, PublisherOptions.latched());
    publisher.publish("map of one", Optional.of("/one"));
    publisher.publish("old map of two", Optional.of("/two"));
    publisher.publish("passing", Optional.empty());
    publisher.publish("map of two", Optional.of("/two"));
    listen(graph.node("listener"), "map", got);
    Eventually.await("both latched messages", () -> got.equals(List.of("map of one", "map of two")));
  }

  @Test
  void aSubscriberHearsAllPublishersAndWhoSpoke() throws Exception {
    List<String> callers = new CopyOnWriteArrayList<>();
    Publisher<String> one = graph.node("one").publisher("tf", TEXT, PublisherOptions.standard());
    Subscriber subscriber = graph.node("listener").subscriber("tf", TEXT, SubscriberOptions.standard(),
        (text, reception) -> callers.add(reception.callerId()));
    Publisher<String> two = graph.node("two").publisher("tf", TEXT, PublisherOptions.standard());
    Eventually.await("both links", () -> subscriber.numPublishers() == 2
        && one.numSubscribers() + two.numSubscribers() == 2);
    one.publish("a");
    two.publish("b");
    Eventually.await("both messages", () -> callers.containsAll(List.of("/one", "/two")));
  }

  @Test
  void aSubscriberOfAnyTypeLearnsTheDefinition() throws Exception {
    List<MessageInfo> infos = new CopyOnWriteArrayList<>();
    graph.node("talker").publisher("chatter", TEXT, PublisherOptions.latched()).publish("x");
    graph.node("listener").subscriber("chatter", new RawCodec(), SubscriberOptions.standard(),
        (raw, reception) -> infos.add(raw.info()));
    Eventually.await("a message", () -> infos.equals(List.of(TEXT.info())));
  }

  @Test
  void differentTypesAreRefusedOnBothSidesWithTheReason() throws Exception {
    LinkLog links = new LinkLog();
    MessageInfo other = new MessageInfo("std_msgs/Int32", "da5909fbe378aeaf85e547e830cc1bb7", "int32 data\n");
    graph.node("talker").publisher("chatter", TEXT, PublisherOptions.standard());
    graph.node("listener", links).subscriber("chatter", new RawCodec(other), SubscriberOptions.standard(),
        (raw, r) -> {});
    links.awaitReason(Kind.SUBSCRIPTION, "/chatter", "std_msgs/Int32", "std_msgs/String", "/talker");
  }

  @Test
  void closingAPublisherEndsItsLinksAndTheMasterForgetsIt() throws Exception {
    RosNode talker = graph.node("talker");
    Publisher<String> publisher = talker.publisher("chatter", TEXT, PublisherOptions.standard());
    RosNode listener = graph.node("listener");
    Subscriber subscriber = listen(listener, "chatter", new CopyOnWriteArrayList<>());
    Eventually.await("a link", () -> subscriber.numPublishers() == 1);
    publisher.close();
    Eventually.await("no link", () -> subscriber.numPublishers() == 0);
    assertTrue(talker.awaitRegistered(Duration.ofSeconds(30)));
    assertEquals(List.of(new TopicInfo("/rosout_agg", "rosgraph_msgs/Log")),
        listener.master().publishedTopics().toOptional().orElseThrow());
  }

  @Test
  void aSubscriberThatHangsCostsMessagesButNoTime() throws Exception {
    java.util.concurrent.CountDownLatch release = new java.util.concurrent.CountDownLatch(1);
    Publisher<String> publisher =
        graph.node("talker").publisher("chatter", TEXT, PublisherOptions.standard().withQueue(10));
    List<String> got = new CopyOnWriteArrayList<>();
    graph.node("slow").subscriber("chatter", TEXT, SubscriberOptions.standard(), (text, reception) -> {
      try {
        release.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    });
    listen(graph.node("quick"), "chatter", got);
    Eventually.await("both links", () -> publisher.numSubscribers() == 2);
    String large = "x".repeat(1 << 20);
    long start = System.nanoTime();
    for (int i = 0; i < 100; i++) {
      publisher.publish(large);
    }
    long millis = (System.nanoTime() - start) / 1_000_000;
    publisher.publish("last");
    Eventually.await("the quick one's last message", () -> got.contains("last"));
    release.countDown();
    assertTrue(publisher.dropped() > 50, "dropped " + publisher.dropped());
    assertTrue(millis < 5_000, "publishing took " + millis + " ms");
  }

  @Test
  void aListenerThatThrowsIsCountedAndTheLinkGoesOn() throws Exception {
    List<String> got = new CopyOnWriteArrayList<>();
    Publisher<String> publisher = graph.node("talker").publisher("chatter", TEXT, PublisherOptions.standard());
    Subscriber subscriber =
        graph.node("listener").subscriber("chatter", TEXT, SubscriberOptions.standard(), (text, r) -> {
          got.add(text);
          throw new IllegalStateException("on purpose");
        });
    Eventually.await("a link", () -> publisher.numSubscribers() == 1);
    publisher.publish("a");
    publisher.publish("b");
    Eventually.await("both", () -> got.equals(List.of("a", "b")));
    Eventually.await("both counted", () -> subscriber.listenerErrors() == 2);
    assertEquals(1, subscriber.numPublishers());
  }

  @Test
  void aTopicIsPublishedOncePerNode() throws Exception {
    RosNode node = graph.node("talker");
    Publisher<String> first = node.publisher("chatter", TEXT, PublisherOptions.standard());
    assertThrows(IllegalStateException.class, () -> node.publisher("/chatter", TEXT, PublisherOptions.standard()));
    first.close();
    node.publisher("chatter", TEXT, PublisherOptions.standard());
    assertThrows(InvalidNameException.class, () -> node.publisher("a b", TEXT, PublisherOptions.standard()));
    assertThrows(IllegalArgumentException.class,
        () -> node.publisher("raw", new RawCodec(), PublisherOptions.standard()));
  }

  @Test
  void aNodeHearsItself() throws Exception {
    List<String> got = new CopyOnWriteArrayList<>();
    RosNode node = graph.node("both");
    Publisher<String> publisher = node.publisher("~echo", TEXT, PublisherOptions.standard());
    Subscriber subscriber = listen(node, "/both/echo", got);
    Eventually.await("the link", () -> publisher.numSubscribers() == 1 && subscriber.numPublishers() == 1);
    publisher.publish("me");
    Eventually.await("the message", () -> got.equals(List.of("me")));
  }

  @Test
  void virtualThreadsDoAsWell() throws Exception {
    List<String> got = new CopyOnWriteArrayList<>();
    NodeOptions options = NodeOptions.standard(Thread.ofVirtual().factory());
    RosEnvironment environment = RosEnvironment.of(graph.master().uri());
    Publisher<String> publisher =
        graph.open(environment, "talker", options).publisher("chatter", TEXT, PublisherOptions.latched());
    listen(graph.open(environment, "listener", options), "chatter", got);
    publisher.publish("light");
    Eventually.await("the message", () -> got.equals(List.of("light")));
  }
}
