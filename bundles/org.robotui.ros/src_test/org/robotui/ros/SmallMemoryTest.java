package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.message.MessageWriter;
import org.robotui.message.RecordCodec;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.slf4j.Logger;

/** A process of 64 MiB among peers that send more than that, or say that they will: the honest link goes on in it. */
class SmallMemoryTest {

  private static final String ALIVE = "the honest link goes on";
  private static final int GIANT = 1 << 29;

  @Test
  @Timeout(120)
  void peersThatSendMoreThanThereIsMemoryCostTheirOwnLinks() throws Exception {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    Process process =
        new ProcessBuilder(java, "-Xmx64m", "-XX:+UseSerialGC", "-Dorg.slf4j.simpleLogger.defaultLogLevel=off", "-cp",
            classPath(), SmallMemoryTest.class.getName()).redirectErrorStream(true).start();
    try (InputStream out = process.getInputStream()) {
      String printed = new String(out.readAllBytes(), StandardCharsets.UTF_8);
      assertEquals(0, process.waitFor(), printed);
      assertEquals(ALIVE, printed.strip().lines().reduce("", (first, last) -> last), printed);
    } finally {
      process.destroyForcibly();
    }
  }

  /** The places of the classes it needs; the class path of a test runner is its own affair. */
  private static String classPath() throws ClassNotFoundException {
    Class<?> failure = Class.forName("org.opentest4j.AssertionFailedError");
    Class<?> commons = Class.forName("org.junit.platform.commons.JUnitException");
    return Stream
        .of(SmallMemoryTest.class, RosNode.class, RecordCodec.class, Workers.class, Logger.class, Test.class, failure,
            commons)
        .map(type -> type.getProtectionDomain().getCodeSource().getLocation())
        .map(location -> Path.of(URI.create(location.toString())).toString())
        .distinct().collect(Collectors.joining(File.pathSeparator));
  }

  /** What runs in the small process. */
  public static void main(String[] arguments) throws Exception {
    LinkLog links = new LinkLog();
    List<String> heard = new CopyOnWriteArrayList<>();
    try (Graph graph = new Graph()) {
      Publisher<String> honest =
          graph.node("honest").publisher("chatter", new TextCodec(), PublisherOptions.standard());
      RosNode victim = graph.open(RosEnvironment.of(graph.master().uri()), "victim",
          graph.options().withLinks(links).withMaxMessageBytes(1L << 30));
      victim.subscriber("chatter", new TextCodec(), SubscriberOptions.standard(), (text, reception) -> heard.add(text));
      Eventually.await("the honest link", () -> honest.numSubscribers() == 1);
      messageAboveMemory(graph, links);
      announcements(victim);
      bodies(victim);
      honest.publish(ALIVE);
      Eventually.await("the honest message", () -> heard.contains(ALIVE));
    }
    System.out.println(heard.getLast());
  }

  /** A publisher that really sends half a gigabyte. */
  private static void messageAboveMemory(Graph graph, LinkLog links) throws Exception {
    byte[] piece = new byte[1 << 20];
    try (FakePublisher giant = new FakePublisher(graph, "/giant", out -> {
      out.write(FakePublisher.goodHeader());
      out.write(new MessageWriter().i32(GIANT).toByteArray());
      for (int i = 0; i < GIANT / piece.length; i++) {
        out.write(piece);
      }
    })) {
      Eventually.await("the giant's failure", Duration.ofSeconds(30),
          () -> links.reasons(LinkEvent.Kind.SUBSCRIPTION).stream()
              .anyMatch(reason -> reason.contains("no memory for its message")));
    }
  }

  /** Connections that say that much is to come. */
  private static void announcements(RosNode victim) throws IOException {
    HostPort http = HostPort.ofUri(victim.uri(), "http");
    List<Socket> sockets = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      Socket socket = new Socket(http.host(), http.port());
      socket.getOutputStream()
          .write("POST / HTTP/1.1\r\nContent-Length: 16000000\r\n\r\n".getBytes(StandardCharsets.ISO_8859_1));
      sockets.add(socket);
    }
    for (Socket socket : sockets) {
      socket.close();
    }
  }

  /** Connections that really send it, all at once. */
  private static void bodies(RosNode victim) throws IOException {
    HostPort http = HostPort.ofUri(victim.uri(), "http");
    byte[] body = "<value/>".repeat(1 << 17).getBytes(StandardCharsets.ISO_8859_1);
    List<Socket> sockets = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      Socket socket = new Socket(http.host(), http.port());
      sockets.add(socket);
      send(socket, body);
    }
    for (Socket socket : sockets) {
      socket.close();
    }
  }

  private static void send(Socket socket, byte[] body) {
    try {
      socket.getOutputStream()
          .write("POST / HTTP/1.1\r\nContent-Length: 16000000\r\n\r\n".getBytes(StandardCharsets.ISO_8859_1));
      for (int i = 0; i < 8; i++) {
        socket.getOutputStream().write(body);
      }
    } catch (IOException e) {
      // refused, as it may be
    }
  }
}
