package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.net.socket.HostPort;

/** What reaches a subscriber that did not take anything for a while, as behind a network that stalls. */
class PromptPublisherTest {

  /** Bytes of a geometry_msgs/Twist. */
  private static final int VELOCITY = 48;

  private Graph graph;
  private RosNode node;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    node = graph.node("driver");
    node.serviceServer("door",
        new org.robotui.message.ServiceCodec<>("test/Echo", "0123456789abcdef0123456789abcdef", new TextCodec(),
            new TextCodec()),
        (request, caller) -> request);
    assertTrue(node.awaitRegistered(java.time.Duration.ofSeconds(30)));
  }

  @AfterEach
  void stop() {
    graph.close();
  }

  private Socket stalled(Publisher<String> publisher) throws IOException {
    HostPort tcp = HostPort.ofUri(node.master().lookupService("/door").toOptional().orElseThrow(), "rosrpc");
    Socket socket = new Socket();
    socket.setReceiveBufferSize(1);
    socket.setSoTimeout(1_000);
    socket.connect(new InetSocketAddress(tcp.host(), tcp.port()));
    socket.getOutputStream().write(ConnectionHeaders.subscriber("/chatter", "*"));
    Eventually.await("the link", () -> publisher.numSubscribers() == 1);
    return socket;
  }

  /** The header, and all that comes until the last one that is expected. */
  private static List<String> received(Socket socket, String last) throws IOException {
    frame(new DataInputStream(socket.getInputStream()));
    return texts(socket, last);
  }

  private static List<String> texts(Socket socket, String last) throws IOException {
    DataInputStream in = new DataInputStream(socket.getInputStream());
    List<String> texts = new ArrayList<>();
    while (texts.isEmpty() || !texts.getLast().equals(last)) {
      byte[] message = frame(in);
      texts.add(new String(message, 4, message.length - 4, java.nio.charset.StandardCharsets.UTF_8));
    }
    return texts;
  }

  private static byte[] frame(DataInputStream in) throws IOException {
    byte[] length = in.readNBytes(4);
    return in.readNBytes(ByteBuffer.wrap(length).order(ByteOrder.LITTLE_ENDIAN).getInt());
  }

  /** Long enough that all buffers on the way are full, and the writer is stuck. */
  private static void drive(Publisher<String> publisher, int bytes) {
    String text = "v".repeat(bytes);
    long begun = System.nanoTime();
    Eventually.await("a stall that lasts", () -> {
      for (int i = 0; i < 100; i++) {
        publisher.publish(text);
      }
      return System.nanoTime() - begun > 500_000_000;
    });
  }

  @Test
  void commandsThatAStalledNetworkHoldsAreFew() throws Exception {
    Publisher<String> publisher = node.publisher("chatter", new TextCodec(), PublisherOptions.commands());
    try (Socket socket = stalled(publisher)) {
      drive(publisher, VELOCITY);
      publisher.publish("newest");
      List<String> late = received(socket, "newest");
      assertTrue(late.size() < 150, late.size() + " commands came late");
    }
  }

  @Test
  void anUrgentMessageIsTheNextOfThoseThatWait() throws Exception {
    Publisher<String> publisher = node.publisher("chatter", new TextCodec(), PublisherOptions.commands());
    try (Socket socket = stalled(publisher)) {
      drive(publisher, VELOCITY);
      publisher.publishUrgently("stop");
      List<String> late = received(socket, "stop");
      assertTrue(late.size() < 150, late.size() + " commands came late");
    }
  }

  @Test
  void urgentMessagesOvertakeWhatWaitsInAQueue() throws Exception {
    Publisher<String> publisher = node.publisher("chatter", new TextCodec(), PublisherOptions.standard());
    try (Socket socket = stalled(publisher)) {
      drive(publisher, 10_000);
      long before = publisher.dropped();
      publisher.publishUrgently("stop");
      received(socket, "stop");
      assertEquals(1000, publisher.dropped() - before);
    }
  }

  @Test
  void itIsKnownWhenAllIsSentAndWhenNot() throws Exception {
    Publisher<String> publisher = node.publisher("/chatter", new TextCodec(), PublisherOptions.standard());
    assertTrue(publisher.awaitSent(java.time.Duration.ZERO), "nobody listens");
    try (Socket socket = stalled(publisher)) {
      publisher.publish("x".repeat(20_000_000));
      assertFalse(publisher.awaitSent(java.time.Duration.ofMillis(200)), "the subscriber does not read");
    }
    assertTrue(publisher.awaitSent(java.time.Duration.ofSeconds(60)), "the subscriber is gone");
  }
}
