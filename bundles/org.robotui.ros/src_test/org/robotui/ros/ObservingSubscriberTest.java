package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What the master remembers of a subscriber to a topic that nobody publishes. */
class ObservingSubscriberTest {

  private Graph graph;
  private RosNode node;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    node = graph.node("observer");
  }

  @AfterEach
  void stop() {
    graph.close();
  }

  private List<TopicInfo> typesAfter(SubscriberOptions options) {
    node.subscriber("nothing", new TextCodec(), options, (text, reception) -> {});
    assertTrue(node.awaitRegistered(Duration.ofSeconds(30)));
    return node.master().topicTypes().toOptional().orElseThrow().stream()
        .filter(topic -> topic.name().equals("/nothing")).toList();
  }

  @Test
  void anObserverTeachesTheMasterNothing() {
    assertEquals(List.of(), typesAfter(SubscriberOptions.observing()));
  }

  @Test
  void othersAnnounceWhichTypeTheyWant() {
    assertEquals(List.of(new TopicInfo("/nothing", "std_msgs/String")), typesAfter(SubscriberOptions.standard()));
  }

  @Test
  void anObserverHearsWhatIsPublishedLater() throws Exception {
    List<String> heard = new java.util.concurrent.CopyOnWriteArrayList<>();
    node.subscriber("chatter", new TextCodec(), SubscriberOptions.observing(), (text, reception) -> heard.add(text));
    Publisher<String> publisher =
        graph.node("talker").publisher("chatter", new TextCodec(), PublisherOptions.latched());
    publisher.publish("hello");
    Eventually.await("the message", () -> heard.contains("hello"));
  }
}
