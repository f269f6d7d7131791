package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;
import org.robotui.ros.LinkEvent.Kind;
import org.robotui.ros.internal.tcpros.ConnectionHeader;

/** Publishers that lie, cut off or say nothing: each costs its own link, with a reason, and nothing else. */
class HostilePublisherTest {

  private final LinkLog links = new LinkLog();
  private final List<String> heard = new CopyOnWriteArrayList<>();
  private Graph graph;
  private Publisher<String> honest;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    honest = graph.node("honest").publisher("chatter", new TextCodec(), PublisherOptions.standard());
    NodeOptions options = graph.options().withLinks(links).withMaxMessageBytes(10_000_000);
    graph.open(RosEnvironment.of(graph.master().uri()), "listener", options)
        .subscriber("chatter", new TextCodec(), SubscriberOptions.standard(), (text, reception) -> heard.add(text));
    Eventually.await("the honest link", () -> honest.numSubscribers() == 1);
  }

  @AfterEach
  void stop() {
    graph.close();
  }

  private void expect(FakePublisher.Script script, String... reason) throws Exception {
    try (FakePublisher liar = new FakePublisher(graph, "/liar", script)) {
      links.awaitReason(Kind.SUBSCRIPTION, concat(reason, "/chatter", "http://127.0.0.1:"));
      Eventually.await("another attempt", () -> liar.connections() > 1);
      honest.publish("still here");
      Eventually.await("the honest publisher's message", () -> heard.contains("still here"));
      assertEquals(1, honest.numSubscribers());
      assertTrue(links.reasons(Kind.SUBSCRIPTION).stream().noneMatch(r -> r.contains("/honest")),
          "the honest link failed");
    }
  }

  private static String[] concat(String[] words, String... more) {
    return java.util.stream.Stream.concat(java.util.stream.Stream.of(words), java.util.stream.Stream.of(more))
        .toArray(String[]::new);
  }

  @Test
  void aHeaderThatIsTooLong() throws Exception {
    expect(out -> out.write(new MessageWriter().i32(0x7fffffff).toByteArray()),
        "connection header of 2147483647 bytes announced");
  }

  @Test
  void aHeaderOfNegativeLength() throws Exception {
    expect(out -> out.write(new MessageWriter().i32(-1).toByteArray()),
        "connection header of 4294967295 bytes announced");
  }

  @Test
  void aHeaderThatIsCutOff() throws Exception {
    expect(out -> out.write(new MessageWriter().i32(100).string("callerid=/x").toByteArray()),
        "connection header cut off: 15 of 100");
  }

  @Test
  void aFieldThatIsLongerThanTheHeader() throws Exception {
    expect(out -> out.write(new MessageWriter().i32(8).i32(1000).i32(0).toByteArray()),
        "field at byte 0 is longer than the header");
  }

  @Test
  void aFieldWithoutAName() throws Exception {
    expect(out -> out.write(new MessageWriter().i32(9).string("hello").toByteArray()),
        "field at byte 0 is not name=value");
  }

  @Test
  void aHeaderWithoutTheMd5Sum() throws Exception {
    byte[] header = new MessageWriter().i32(24).string("type=std_msgs/String").toByteArray();
    expect(out -> out.write(header), "without field 'md5sum'");
  }

  @Test
  void noHeaderAtAll() throws Exception {
    CountDownLatch end = new CountDownLatch(1);
    try (FakePublisher liar = new FakePublisher(graph, "/liar", out -> await(end))) {
      links.awaitReason(Kind.SUBSCRIPTION, "/chatter", "no answer within 2000 ms");
    } finally {
      end.countDown();
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
  void aHeaderThatDrips() throws Exception {
    CountDownLatch end = new CountDownLatch(1);
    try (FakePublisher liar = new FakePublisher(graph, "/liar", out -> {
      out.write(new MessageWriter().i32(10_000).toByteArray());
      while (end.getCount() > 0) {
        out.write('x');
        LockSupport.parkNanos(50_000_000);
      }
    })) {
      links.awaitReason(Kind.SUBSCRIPTION, "/chatter", "http://127.0.0.1:", "no answer within 2000 ms");
    } finally {
      end.countDown();
    }
  }

  @Test
  void anotherMd5Sum() throws Exception {
    byte[] other = ConnectionHeader.of("/liar")
        .with(new MessageInfo("std_msgs/Int32", "da5909fbe378aeaf85e547e830cc1bb7", "int32 data\n")).encode();
    expect(out -> out.write(other), "/liar", "std_msgs/Int32 with MD5 sum da5909fbe378aeaf85e547e830cc1bb7",
        "expected std_msgs/String");
  }

  @Test
  void aMessageThatDripsHoldsUpNoOther() throws Exception {
    CountDownLatch end = new CountDownLatch(1);
    try (FakePublisher liar = new FakePublisher(graph, "/liar", out -> {
      out.write(FakePublisher.goodHeader());
      out.write(new MessageWriter().i32(9_000_000).toByteArray());
      while (end.getCount() > 0) {
        out.write('x');
        LockSupport.parkNanos(50_000_000);
      }
    })) {
      Eventually.await("the link of the one that drips", () -> links.connected(Kind.SUBSCRIPTION) >= 2);
      honest.publish("meanwhile");
      Eventually.await("the honest publisher's message", () -> heard.contains("meanwhile"));
    } finally {
      end.countDown();
    }
  }

  @Test
  void namesAndReasonsWithoutEndAreCutToWhatCanBeRead() throws Exception {
    byte[] book = ConnectionHeader.error("/liar" + "r".repeat(100_000), "no\n".repeat(100_000)).encode();
    expect(out -> out.write(book), "/liarrr");
    assertTrue(links.reasons(Kind.SUBSCRIPTION).stream()
        .allMatch(reason -> reason.length() < 600 && reason.indexOf('\n') < 0));
  }

  @Test
  void aMessageAboveTheLimit() throws Exception {
    expect(out -> {
      out.write(FakePublisher.goodHeader());
      out.write(new MessageWriter().i32(-2).toByteArray());
    }, "/liar", "message of 4294967294 bytes announced, at most 10000000");
  }

  @Test
  void aMessageThatIsCutOff() throws Exception {
    expect(out -> {
      out.write(FakePublisher.goodHeader());
      out.write(FakePublisher.message("before"));
      out.write(new MessageWriter().i32(9_000_000).i32(1).toByteArray());
    }, "/liar", "message cut off: 4 of 9000000 bytes came");
    assertTrue(heard.contains("before"));
  }

  @Test
  void aLengthThatIsCutOff() throws Exception {
    expect(out -> {
      out.write(FakePublisher.goodHeader());
      out.write(new byte[]{1, 2});
    }, "/liar", "cut off in the length of message");
  }

  @Test
  void aMessageThatDoesNotDecode() throws Exception {
    expect(out -> {
      out.write(FakePublisher.goodHeader());
      out.write(new MessageWriter().i32(8).i32(1000).i32(0).toByteArray());
    }, "/liar", "message that is no std_msgs/String", "in field data at byte 0");
  }

  @Test
  void anErrorHeader() throws Exception {
    expect(out -> out.write(ConnectionHeaders.error("go away")), "the publisher refused: go away");
  }

  @Test
  void lyingPublishersAreTriedEverMoreRarely() throws Exception {
    try (FakePublisher liar = new FakePublisher(graph, "/liar", out -> out.write(new byte[]{-1, -1, -1, -1}))) {
      Eventually.await("some attempts", () -> liar.connections() >= 4);
      List<Long> pauses = links.events().stream().map(LinkEvent::state)
          .filter(LinkState.Failed.class::isInstance).map(state -> ((LinkState.Failed) state).retryAfter().toMillis())
          .toList();
      assertTrue(pauses.get(2) > pauses.get(0) && pauses.stream().allMatch(pause -> pause <= 500), pauses.toString());
    }
  }
}
