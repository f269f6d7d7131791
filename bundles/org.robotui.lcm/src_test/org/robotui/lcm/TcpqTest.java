package org.robotui.lcm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.lcm.tcpq.TcpqServer;
import org.robotui.lcm.tcpq.TcpqServerOptions;

/** Clients and servers of messages, honest ones and others. */
class TcpqTest {

  private final TestThreads threads = new TestThreads();
  private final List<AutoCloseable> open = new ArrayList<>();
  private final List<LcmState> states = new CopyOnWriteArrayList<>();
  private final Heard heard = new Heard();
  private int port;

  @BeforeEach
  void start() throws IOException {
    port = Ports.free();
  }

  @AfterEach
  void stop() throws Exception {
    for (AutoCloseable each : open) {
      each.close();
    }
    threads.assertNoneLeft();
  }

  private TcpqServerOptions options() {
    return TcpqServerOptions.loopback(threads, port);
  }

  private TcpqServer server(TcpqServerOptions options) throws IOException {
    TcpqServer server = TcpqServer.open(options);
    open.add(server);
    return server;
  }

  private Lcm client() {
    Lcm lcm = Lcm.open(LcmUrl.of("tcpq://127.0.0.1:" + port), LcmOptions.standard(threads).withStates(states::add)
        .withTimes(Duration.ofSeconds(60), Duration.ofMillis(200)));
    open.add(lcm);
    return lcm;
  }

  private static Lcm connected(Lcm lcm) {
    Eventually.await("the server: " + lcm.state(), () -> lcm.state() instanceof LcmState.Connected);
    return lcm;
  }

  /**
   * What a client asks for may reach the server after what another one publishes: so it is published until it comes.
   */
  private void reaches(Lcm from, String channel, String text) {
    Eventually.await(channel, () -> {
      try {
        from.publish(channel, Heard.text(text));
      } catch (IOException e) {
        return false;
      }
      return heard.texts().contains(channel + "=" + text);
    });
  }

  @Test
  void messagesGoThroughTheServerToThoseWhoSubscribed() throws IOException {
    TcpqServer server = server(options());
    Lcm one = connected(client());
    Lcm other = connected(client());
    Subscription subscription = other.subscribe("POSE|BIG", SubscriptionOptions.direct(), heard);
    reaches(one, "POSE", "here");
    one.publish("OTHER", Heard.text("x"));
    one.publish("BIG", Heard.bytes(5_000_000, 3));
    Eventually.await("the long one", () -> heard.messages().getLast().channel().equals("BIG"));
    assertEquals(Heard.bytes(5_000_000, 3), heard.messages().getLast().data());
    assertEquals("127.0.0.1:" + port, heard.messages().getLast().sender());
    subscription.close();
    other.subscribe("NEXT", SubscriptionOptions.direct(), heard);
    reaches(one, "NEXT", "later");
    assertTrue(heard.texts().stream().noneMatch(text -> text.startsWith("OTHER")));
    assertEquals(2, server.clients());
  }

  @Test
  void aServerThatReturnsIsFoundAndToldOfTheSubscriptions() throws Exception {
    Lcm one = client();
    one.subscribe("POSE", SubscriptionOptions.direct(), heard);
    Eventually.await("a failure", () -> states.stream().anyMatch(LcmState.Failed.class::isInstance));
    String reason =
        ((LcmState.Failed) states.stream().filter(LcmState.Failed.class::isInstance).findFirst().orElseThrow())
            .reason();
    assertTrue(reason.contains("cannot reach the LCM server 127.0.0.1:" + port), reason);
    TcpqServer first = server(options());
    reaches(connected(one), "POSE", "first");
    first.close();
    Eventually.await("the loss", () -> one.state() instanceof LcmState.Failed);
    assertTrue(one.state().toString().contains("127.0.0.1:" + port), one.state().toString());
    server(options());
    reaches(connected(one), "POSE", "second");
  }

  @Test
  void aClientThatDoesNotReadCostsItsOwnMessagesOnly() throws IOException {
    TcpqServer server = server(options().withBounds(1 << 20, 1 << 20, 8));
    Lcm reader = connected(client());
    reader.subscribe("END", SubscriptionOptions.direct(), heard);
    Lcm writer = connected(client());
    try (Socket lazy = new Socket(InetAddress.getLoopbackAddress(), port)) {
      lazy.getOutputStream().write(ByteBuffer.allocate(18).putInt(0x287617fb).putInt(0x100).putInt(2).putInt(2)
          .put((byte) '.').put((byte) '*').array());
      Eventually.await("lost messages of the lazy one", () -> {
        try {
          writer.publish("DATA", Heard.bytes(500_000, 1));
        } catch (IOException e) {
          throw new AssertionError(e);
        }
        return server.dropped() > 3;
      });
      reaches(writer, "END", "still here");
    }
  }

  /** Frames in hexadecimal digits after the greeting of a client. */
  @ParameterizedTest
  @CsvSource(textBlock = """
      junk instead of a greeting,      00000000 00000000
      another version,                 287617fb 00000200
      an unknown frame,                287617fb 00000100 00000009
      a channel of 4 GB,               287617fb 00000100 00000001 ffffffff
      a message of 2 GB,               287617fb 00000100 00000001 00000001 41 7fffffff
      no regular expression,           287617fb 00000100 00000002 00000001 28
      """)
  void clientsThatLieAreSentAway(String what, String frames) throws IOException {
    TcpqServer server = server(options());
    Lcm honest = connected(client());
    honest.subscribe("POSE", SubscriptionOptions.direct(), heard);
    try (Socket liar = new Socket(InetAddress.getLoopbackAddress(), port)) {
      liar.getOutputStream().write(HexFormat.of().parseHex(frames.replace(" ", "")));
      Eventually.await(what, () -> server.refused() == 1);
      liar.getInputStream().readAllBytes(); // closed by the server
    }
    reaches(honest, "POSE", "still here");
  }

  @Test
  void clientsThatSayNothingAreSentAwayAndNoMoreAreLetInThanAreAllowed() throws IOException {
    TcpqServer server = server(options().withBounds(1 << 20, 1 << 20, 3).withGreetingTime(Duration.ofMillis(300)));
    List<Socket> silent = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      silent.add(new Socket(InetAddress.getLoopbackAddress(), port));
    }
    for (Socket each : silent) {
      assertEquals(0, each.getInputStream().readAllBytes().length);
      each.close();
    }
    Eventually.await("refusals", () -> server.refused() == 6);
    connected(client());
  }

  /** Each byte comes soon after the one before, and the whole never. */
  @Test
  void aGreetingThatDripsIsNotWaitedFor() throws IOException {
    TcpqServer server = server(options().withGreetingTime(Duration.ofMillis(300)));
    try (Socket dripping = new Socket(InetAddress.getLoopbackAddress(), port)) {
      threads.newThread(() -> drip(dripping)).start();
      Eventually.await("a refusal", Duration.ofSeconds(20), () -> server.refused() == 1);
    }
  }

  private static void drip(Socket socket) {
    try {
      for (byte each : HexFormat.of().parseHex("287617fb000001")) {
        socket.getOutputStream().write(each);
        LockSupport.parkNanos(Duration.ofMillis(200).toNanos());
      }
      socket.getInputStream().readAllBytes();
    } catch (IOException e) {
      // sent away
    }
  }

  /** It looks at a text of 40 letters two to the power of 40 times. */
  @Test
  void anExpressionWithoutEndHoldsUpNobody() throws IOException {
    server(options());
    Lcm bad = connected(client());
    bad.subscribe("(a+)+b", SubscriptionOptions.direct(), heard);
    Lcm honest = connected(client());
    honest.subscribe("POSE", SubscriptionOptions.direct(), heard);
    for (int i = 0; i < 5; i++) {
      honest.publish("a".repeat(40), Heard.text(""));
    }
    reaches(honest, "POSE", "still here");
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = """
      12345678 00000100                               | it speaks no LCM: its first word is 0x12345678
      287617fa 00000300                               | it speaks version 0x300
      287617fa 00000100 00000007                      | it sends a frame of unknown type 7
      287617fa 00000100 00000001 00000001 41 ffffffff | it announces a message on A of 4294967295 bytes
      287617fa 00000100 00000001 00000001 41 00000100 | closed the connection: a message on A was cut off: 0 of 256 bytes came
      287617fa 00000100 00000002 00000001 41          | sends requests, as a client does
      """)
  void serversThatLieAreNamedAndTriedAgain(String frames, String reason) throws IOException {
    try (ServerSocket liar = new ServerSocket(port, 5, InetAddress.getLoopbackAddress())) {
      Thread thread = threads.newThread(() -> lie(liar, HexFormat.of().parseHex(frames.replace(" ", ""))));
      thread.start();
      client();
      Eventually.await(() -> reason + " among " + states,
          () -> states.stream().filter(state -> state.toString().contains(reason)
              && state.toString().contains("127.0.0.1:" + port)).count() >= 2);
    }
  }

  private static void lie(ServerSocket socket, byte[] bytes) {
    while (!socket.isClosed()) {
      try (Socket victim = socket.accept()) {
        victim.getInputStream().readNBytes(8);
        victim.getOutputStream().write(bytes);
      } catch (IOException e) {
        // the victim left, or the test is over
      }
    }
  }

  @Test
  void namesOfChannelsAreText() throws IOException {
    server(options());
    Lcm one = connected(client());
    one.subscribe("Größe", SubscriptionOptions.direct(), heard);
    reaches(one, "Größe", "ü");
    assertEquals("Größe",
        new String(heard.messages().getFirst().channel().getBytes(StandardCharsets.UTF_8), StandardCharsets.UTF_8));
  }
}
