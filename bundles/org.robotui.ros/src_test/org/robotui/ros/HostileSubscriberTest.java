package org.robotui.ros;

import org.robotui.net.call.Outcome;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageWriter;
import org.robotui.message.ServiceCodec;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.LinkEvent.Kind;

/** Subscribers and service clients that send what they should not. */
class HostileSubscriberTest {

  private static final ServiceCodec<String, String> ECHO =
      new ServiceCodec<>("test/Echo", "0123456789abcdef0123456789abcdef",
          new TextCodec(), new TextCodec());

  private final LinkLog links = new LinkLog();
  private final List<String> heard = new CopyOnWriteArrayList<>();
  private Graph graph;
  private Publisher<String> publisher;
  private HostPort tcp;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    RosNode node = graph.node("server", links);
    publisher = node.publisher("chatter", new TextCodec(), PublisherOptions.standard());
    node.serviceServer("echo", ECHO, (request, caller) -> request);
    RosNode listener = graph.node("honest");
    listener.subscriber("chatter", new TextCodec(), SubscriberOptions.standard(), (text, reception) -> heard.add(text));
    Eventually.await("the honest link", () -> publisher.numSubscribers() == 1);
    Eventually.await("the service", () -> listener.master().lookupService("/echo") instanceof Outcome.Done);
    tcp = HostPort.ofUri(listener.master().lookupService("/echo").toOptional().orElseThrow(), "rosrpc");
  }

  @AfterEach
  void stop() {
    publisher.publish("still here");
    Eventually.await("the honest link's message", () -> heard.contains("still here"));
    graph.close();
  }

  private byte[] answerTo(byte[] bytes) throws IOException {
    try (Socket socket = new Socket(tcp.host(), tcp.port())) {
      socket.setSoTimeout(5_000);
      socket.getOutputStream().write(bytes);
      return socket.getInputStream().readAllBytes();
    }
  }

  private void expectRefusal(byte[] bytes, String... words) throws IOException {
    String answer = new String(answerTo(bytes), StandardCharsets.UTF_8);
    for (String word : words) {
      assertTrue(answer.contains("error=") && answer.contains(word), "'" + word + "' in: " + answer);
    }
  }

  @Test
  void anUnknownTopicIsRefusedWithItsName() throws Exception {
    expectRefusal(ConnectionHeaders.subscriber("/nowhere", "*"), "/nowhere");
  }

  @Test
  void anotherTypeIsRefusedWithBothSums() throws Exception {
    expectRefusal(ConnectionHeaders.subscriber("/chatter", "abc"), "abc", "992ce8a1687cec8c8bd883ec73ca41d1",
        "/chatter");
    links.awaitReason(Kind.PUBLICATION, "/chatter", "/liar", "abc", "992ce8a1687cec8c8bd883ec73ca41d1");
  }

  @Test
  void aClientOfAnotherServiceTypeIsRefusedWithBothSums() throws Exception {
    expectRefusal(ConnectionHeaders.client("/echo", "abc"), "/echo", "abc", ECHO.md5());
    links.awaitReason(Kind.SERVICE, "/echo", "/liar", "abc", ECHO.md5());
  }

  @Test
  void anUnknownServiceIsRefusedWithItsName() throws Exception {
    expectRefusal(ConnectionHeaders.client("/nowhere", "*"), "/nowhere");
  }

  @Test
  void aHeaderThatIsTooLongIsRefused() throws Exception {
    expectRefusal(new MessageWriter().i32(2_000_000).toByteArray(), "connection header of 2000000 bytes announced");
  }

  @Test
  void aHeaderThatNamesNothingIsRefused() throws Exception {
    expectRefusal(new MessageWriter().i32(10).string("a=bcde").toByteArray(), "without field 'topic'");
  }

  @Test
  void silenceIsEndedAfterTheHandshakeTime() throws Exception {
    assertArrayEquals(new byte[0], answerTo(new byte[0]));
  }

  @Test
  void aSubscriberThatTalksIsClosed() throws Exception {
    try (Socket socket = new Socket(tcp.host(), tcp.port())) {
      socket.getOutputStream().write(ConnectionHeaders.subscriber("/chatter", "*"));
      Eventually.await("a second link", () -> publisher.numSubscribers() == 2);
      socket.getOutputStream().write(1);
      links.awaitReason(Kind.PUBLICATION, "/chatter", "/liar", "bytes where none belong");
      Eventually.await("one link", () -> publisher.numSubscribers() == 1);
    }
  }

  @Test
  void aRequestThatIsTooLongEndsTheConnectionWithTheReason() throws Exception {
    try (Socket socket = new Socket(tcp.host(), tcp.port())) {
      socket.getOutputStream().write(ConnectionHeaders.client("/echo", ECHO.md5()));
      socket.getOutputStream().write(new MessageWriter().i32(-1).toByteArray());
      links.awaitReason(Kind.SERVICE, "/echo", "/liar", "request of 4294967295 bytes");
    }
  }

  @Test
  void aRequestThatDoesNotDecodeEndsTheConnectionWithTheReason() throws Exception {
    try (Socket socket = new Socket(tcp.host(), tcp.port())) {
      socket.getOutputStream().write(ConnectionHeaders.client("/echo", ECHO.md5()));
      socket.getOutputStream().write(new MessageWriter().i32(4).i32(77).toByteArray());
      links.awaitReason(Kind.SERVICE, "/echo", "/liar", "request that is no test/Echo", "data");
    }
  }

  @Test
  void aPersistentConnectionAnswersManyRequestsInOnePacket() throws Exception {
    try (Socket socket = new Socket(tcp.host(), tcp.port())) {
      socket.setSoTimeout(5_000);
      socket.getOutputStream().write(ConnectionHeaders.client("/echo", ECHO.md5()));
      socket.getOutputStream().write(new MessageWriter().i32(5).string("a").i32(5).string("b").toByteArray());
      byte[] header = socket.getInputStream().readNBytes(4);
      socket.getInputStream().readNBytes(header[0] & 0xff | (header[1] & 0xff) << 8);
      byte[] expected = new MessageWriter().u8(1).i32(5).string("a").u8(1).i32(5).string("b").toByteArray();
      assertArrayEquals(expected, socket.getInputStream().readNBytes(expected.length));
    }
    assertEquals(1, publisher.numSubscribers());
  }
}
