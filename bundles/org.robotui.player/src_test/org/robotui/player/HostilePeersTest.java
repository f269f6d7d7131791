package org.robotui.player;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.player.client.LinkState;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServerOptions;
import org.robotui.player.server.TypedHandler;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.Framing;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerMessage;

/** Peers that lie, stop in the middle, or do not answer. */
@Timeout(300)
class HostilePeersTest {

  private static final Duration SHORT = Duration.ofMillis(300);
  private static final DeviceAddress SERVER = DeviceId.SERVER.at(0, 6665);

  private final World world = new World();

  @AfterEach
  void close() throws Exception {
    world.close();
  }

  /** Sends the same bytes to everybody and then nothing. */
  private ServerSocket liar(ByteBuffer... said) throws IOException {
    ServerSocket server = world.closing(new ServerSocket(0, 50, InetAddress.getLoopbackAddress()));
    List<Socket> sockets = new CopyOnWriteArrayList<>();
    world.threads.newThread(() -> {
      try {
        while (true) {
          Socket socket = server.accept();
          sockets.add(socket);
          for (ByteBuffer each : said) {
            byte[] bytes = new byte[each.remaining()];
            each.duplicate().get(bytes);
            socket.getOutputStream().write(bytes);
          }
        }
      } catch (IOException e) {
        sockets.forEach(HostilePeersTest::closeQuietly);
      }
    }).start();
    return server;
  }

  private static void closeQuietly(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private String reasonOf(ServerSocket server) {
    PlayerClient client = world.client(server.getLocalPort(), options -> options.withTimes(SHORT, SHORT, SHORT, SHORT));
    Eventually.await("the link fails", () -> world.links.stream().anyMatch(LinkState.Failed.class::isInstance));
    LinkState.Failed failed =
        (LinkState.Failed) world.links.stream().filter(LinkState.Failed.class::isInstance).findFirst().orElseThrow();
    assertTrue(failed.reason().startsWith("127.0.0.1:" + server.getLocalPort()), failed.reason());
    client.close();
    return failed.reason();
  }

  private static void has(String reason, String part) {
    assertTrue(reason.contains(part), reason);
  }

  @Test
  void anotherServer() throws IOException {
    has(reasonOf(liar(ByteBuffer.wrap("HTTP/1.1 400 Bad Request and then some more".getBytes()))), "HTTP/1.1 400");
  }

  @Test
  void aServerThatSaysNothing() throws IOException {
    has(reasonOf(liar()), "in time");
  }

  @Test
  void aServerThatStopsInItsGreeting() throws IOException {
    has(reasonOf(liar(Framing.banner("3.1").slice(0, 20))), "in time");
  }

  @Test
  void aServerThatAnnouncesTooMuch() throws IOException {
    ByteBuffer header = Framing.bytes(PlayerMessage.empty(SERVER, MessageType.ACK, 1)).putInt(36, Integer.MAX_VALUE);
    has(reasonOf(liar(Framing.banner("3.1"), header)), "2147483647 bytes");
  }

  @Test
  void aServerWhoseListLies() throws IOException {
    PlayerMessage list =
        PlayerMessage.of(SERVER, MessageType.ACK, 1, ByteBuffer.allocate(8).putInt(1 << 28).putInt(1 << 28).flip());
    has(reasonOf(liar(Framing.banner("3.1"), Framing.bytes(list.withSequence(1)))), "devices: ");
  }

  @Test
  void aClientEndsWhileItsServerHangs() throws IOException {
    PlayerClient client = world.client(liar(Framing.banner("3.1")).getLocalPort());
    Eventually.await("it tries", () -> world.links.contains(new LinkState.Connecting()));
    long begin = System.nanoTime();
    client.close();
    assertTrue(Duration.ofNanos(System.nanoTime() - begin).compareTo(Duration.ofSeconds(20)) < 0,
        "handshakes may take a minute here");
    assertEquals(new LinkState.Closed(), client.state());
  }

  @Test
  void aServerGoesOnWhateverItsClientsSay() throws IOException {
    PlayerServer server = world.server(ServerOptions.loopback(world.threads, 0, () -> 0).withBounds(8, 16, SHORT));
    server.add("position2d", 0, "sim", new TypedHandler(world.layouts, none -> {}).on(Position2d.VELOCITY, none -> {
      throw new IllegalStateException("a handler that fails");
    }));
    byte[] half = new byte[20];
    byte[] noise = new byte[4_000];
    Arrays.fill(noise, (byte) 0x5a);
    byte[] data = Framing.bytes(PlayerMessage.empty(SERVER, MessageType.DATA, 1)).array();
    for (byte[] bytes : List.of(half, noise, data)) {
      assertClosed(server.port(), bytes);
    }
    World.awaitLink(world.client(server.port()));
  }

  private static void assertClosed(int port, byte[] said) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      socket.setSoTimeout((int) World.LONG.toMillis());
      socket.getOutputStream().write(said);
      try {
        while (socket.getInputStream().read() >= 0) {
          continue;
        }
      } catch (SocketException e) {
        assertTrue(e.getMessage().contains("reset"), e.getMessage());
      }
    }
  }

  @Test
  void aClientThatNeverReadsIsCutOff() throws IOException {
    PlayerServer server = world.server(0);
    byte[] list = Framing.bytes(PlayerMessage.empty(SERVER, MessageType.REQUEST, 1)).array();
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
      boolean[] cut = {false};
      Eventually.await("it is cut off", () -> {
        try {
          for (int i = 0; i < 1_000; i++) {
            socket.getOutputStream().write(list);
          }
        } catch (IOException e) {
          cut[0] = true;
        }
        return cut[0];
      });
    }
    World.awaitLink(world.client(server.port()));
  }
}
