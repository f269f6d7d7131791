package org.robotui.ros;

import org.robotui.net.call.Outcome;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.message.ServiceCodec;
import org.robotui.testkit.MachineLoad;

class CloseTest {

  private static final TextCodec TEXT = new TextCodec();

  private static void assertQuick(RosNode node) {
    long start = System.nanoTime();
    node.close();
    long millis = (System.nanoTime() - start) / 1_000_000;
    assertTrue(millis < 1_000 * MachineLoad.factor(), "close took " + millis + " ms");
  }

  @Test
  void closingUnregistersEverything() throws Exception {
    try (Graph graph = new Graph()) {
      RosNode node = graph.node("node");
      RosNode watcher = graph.node("watcher");
      for (int i = 0; i < 20; i++) {
        node.publisher("out" + i, TEXT, PublisherOptions.standard());
        node.subscriber("in" + i, TEXT, SubscriberOptions.standard(), (text, reception) -> {});
      }
      node.serviceServer("service", new ServiceCodec<>("a/B", "*", TEXT, TEXT), (request, caller) -> request);
      assertTrue(node.awaitRegistered(Duration.ofSeconds(10)));
      assertTrue(watcher.master().systemState().toOptional().orElseThrow().nodes().contains("/node"));
      assertQuick(node);
      SystemState after = watcher.master().systemState().toOptional().orElseThrow();
      assertTrue(!after.nodes().contains("/node"), after.toString());
      assertTrue(watcher.master().lookupNode("/node") instanceof Outcome.Refused);
      assertEquals("closed by its owner", node.whenClosed().toCompletableFuture().get());
      assertThrows(IllegalStateException.class, () -> node.publisher("late", TEXT, PublisherOptions.standard()));
    }
  }

  @Test
  void whoClosesBecauseItWasInterruptedStillTellsTheMaster(@TempDir Path records) throws Exception {
    try (Graph graph = new Graph()) {
      RosNode node = graph.open(RosEnvironment.of(graph.master().uri()), "node", graph.options().withRecords(records));
      for (int i = 0; i < 20; i++) {
        node.publisher("out" + i, TEXT, PublisherOptions.standard());
      }
      assertTrue(node.awaitRegistered(Duration.ofSeconds(10)));
      Thread.currentThread().interrupt();
      node.close();
      assertTrue(Thread.interrupted(), "the caller may want to know");
      try (Stream<Path> left = Files.list(records)) {
        assertEquals(List.of(), left.toList(), "what a node leaves that its master has not answered");
      }
    }
  }

  @Test
  void theMasterForgetsWhoLeavesWhileItsLinksStayUntilItIsClosed() throws Exception {
    try (Graph graph = new Graph()) {
      RosNode node = graph.node("node");
      AtomicInteger heard = new AtomicInteger();
      node.subscriber("chatter", TEXT, SubscriberOptions.standard(), (text, reception) -> heard.incrementAndGet());
      Publisher<String> publisher = graph.node("talker").publisher("chatter", TEXT, PublisherOptions.standard());
      Eventually.await("a link", () -> publisher.numSubscribers() == 1);
      node.leave();
      node.leave();
      RosNode watcher = graph.node("watcher");
      Eventually.await("forgotten",
          () -> !watcher.master().systemState().toOptional().orElseThrow().nodes().contains("/node"));
      publisher.publish("still here?");
      Eventually.await("heard", () -> heard.get() == 1);
      node.subscriber("late", TEXT, SubscriberOptions.standard(), (text, reception) -> {});
      assertQuick(node);
      assertFalse(watcher.master().systemState().toOptional().orElseThrow().nodes().contains("/node"));
    }
  }

  @Test
  void whatIsBeingRegisteredWhenItLeavesIsForgottenAsWell() throws Exception {
    try (Graph graph = new Graph()) {
      RosNode watcher = graph.node("watcher");
      for (int round = 0; round < 20; round++) {
        RosNode node = graph.node("node" + round);
        node.publisher("first", TEXT, PublisherOptions.standard());
        assertTrue(node.awaitRegistered(Duration.ofSeconds(10)));
        for (int i = 0; i < 20; i++) {
          node.subscriber("in" + i, TEXT, SubscriberOptions.standard(), (text, reception) -> {});
        }
        LockSupport.parkNanos(round * 500_000L);
        assertQuick(node);
      }
      assertEquals(List.of(), watcher.master().systemState().toOptional().orElseThrow().nodes().stream()
          .filter(name -> name.startsWith("/node")).toList());
    }
  }

  @Test
  void aMasterThatHangsDoesNotHoldUpClose() throws Exception {
    TestThreads threads = new TestThreads();
    try (ServerSocket silent = new ServerSocket(0, 50, InetAddress.getByName("127.0.0.1"))) {
      RosNode node = RosNode.open(RosEnvironment.of(URI.create("http://127.0.0.1:" + silent.getLocalPort())),
          GraphName.of("node"), NodeOptions.standard(threads));
      node.publisher("out", TEXT, PublisherOptions.standard());
      node.subscriber("in", TEXT, SubscriberOptions.standard(), (text, reception) -> {});
      assertQuick(node);
      threads.assertNoneLeft();
    }
  }

  @Test
  void aMasterThatHangsLaterDoesNotHoldUpCloseEither() throws Exception {
    try (Graph graph = new Graph()) {
      RosNode node = graph.node("node");
      node.publisher("out", TEXT, PublisherOptions.standard());
      assertTrue(node.awaitRegistered(Duration.ofSeconds(10)));
      int port = graph.master().uri().getPort();
      graph.master().close();
      try (ServerSocket silent = new ServerSocket()) {
        silent.setReuseAddress(true);
        silent.bind(new java.net.InetSocketAddress("127.0.0.1", port));
        assertQuick(node);
      }
    }
  }

  @Test
  void aMasterThatIsNotThereDoesNotHoldUpClose() throws Exception {
    TestThreads threads = new TestThreads();
    RosNode node = RosNode.open(RosEnvironment.of(URI.create("http://127.0.0.1:1")), GraphName.of("node"),
        NodeOptions.standard(threads));
    node.publisher("out", TEXT, PublisherOptions.standard());
    assertQuick(node);
    threads.assertNoneLeft();
  }

  @Test
  void aSubscriberThatReadsNothingDoesNotHoldUpClose() throws Exception {
    CountDownLatch release = new CountDownLatch(1);
    try (Graph graph = new Graph()) {
      RosNode talker = graph.node("talker");
      Publisher<String> publisher = talker.publisher("chatter", TEXT, PublisherOptions.standard());
      graph.node("slow").subscriber("chatter", TEXT, SubscriberOptions.standard(), (text, reception) -> await(release));
      Eventually.await("a link", () -> publisher.numSubscribers() == 1);
      for (int i = 0; i < 30; i++) {
        publisher.publish("x".repeat(1 << 20));
      }
      assertQuick(talker);
      release.countDown();
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void aListenerMayCloseItsOwnNode() throws Exception {
    try (Graph graph = new Graph()) {
      RosNode listener = graph.node("listener");
      Publisher<String> publisher = graph.node("talker").publisher("chatter", TEXT, PublisherOptions.latched());
      listener.subscriber("chatter", TEXT, SubscriberOptions.standard(), (text, reception) -> listener.close());
      publisher.publish("end");
      assertEquals("closed by its owner",
          listener.whenClosed().toCompletableFuture().get(5, java.util.concurrent.TimeUnit.SECONDS));
    }
  }

  @Test
  void anotherNodeOfTheSameNameEndsTheFirst() throws Exception {
    try (Graph graph = new Graph()) {
      RosNode first = graph.node("twin");
      first.publisher("one", TEXT, PublisherOptions.standard());
      assertTrue(first.awaitRegistered(Duration.ofSeconds(10)));
      RosNode second = graph.node("twin");
      second.publisher("two", TEXT, PublisherOptions.standard());
      String reason = first.whenClosed().toCompletableFuture().get(10, java.util.concurrent.TimeUnit.SECONDS);
      assertTrue(reason.contains("/master") && reason.contains("new node registered with same name"), reason);
      Eventually.await("the second one's topic alone",
          () -> second.master().publishedTopics().toOptional().orElseThrow()
              .stream().map(TopicInfo::name).toList().equals(List.of("/rosout_agg", "/two")));
    }
  }
}
