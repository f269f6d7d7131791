package org.robotui.rfic.player.internal;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.command.VelocityCommand;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Power;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServedDevice;
import org.robotui.player.server.ServerOptions;

/** Servers that are not there, are something else, hang, refuse, or come back. */
class PlayerLinkTest extends PlayerRficCase {
  private static final Position2d.State STATE =
      new Position2d.State(new Pose2d(1, 2, 0.5), new Pose2d(0.3, 0, -0.1), false);
  private static final Power.State POWER = new Power.State(9, 24, 50, 0, 0, 0);

  private void awaitFailure(String part) {
    await("the link fails with '" + part + "', is " + link(),
        () -> context.links.stream().anyMatch(l -> l instanceof LinkState.Failed && l.reason().contains(part)));
  }

  private void closesInTime() {
    long before = System.nanoTime();
    rfic.close();
    long millis = Duration.ofNanos(System.nanoTime() - before).toMillis();
    assertTrue(millis < 5000, "closing took " + millis + " ms");
    await("no thread is left: " + context.alive(), () -> context.alive().isEmpty());
    assertInstanceOf(LinkState.Disconnected.class, link());
  }

  @Test
  void aServerThatIsNotThereIsNamedWithARemedy() {
    int port = server.port();
    server.close();
    start(Map.of("port", (long) port));
    awaitFailure("127.0.0.1:" + port);
    awaitFailure("start it");
    closesInTime();
  }

  @Test
  void somethingElseIsNoServer() throws IOException {
    try (ServerSocket other = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      DAEMONS.newThread(() -> greet(other, "SSH-2.0-OpenSSH_9.6 and so on, 32 bytes")).start();
      start(Map.of("port", (long) other.getLocalPort()));
      awaitFailure("no Player server");
      awaitFailure("6665");
      closesInTime();
    }
  }

  private static void greet(ServerSocket listening, String greeting) {
    try (Socket socket = listening.accept(); OutputStream out = socket.getOutputStream()) {
      out.write(greeting.getBytes(StandardCharsets.US_ASCII));
      socket.getInputStream().read();
    } catch (IOException e) {
      // the test has ended
    }
  }

  @Test
  void aKeyIsNeededAndTheRightOne() throws IOException {
    server.close();
    ServerOptions options =
        ServerOptions.loopback(DAEMONS, 0, () -> STAMP).withKey("sesame".getBytes(StandardCharsets.US_ASCII));
    server = new PlayerServer(layouts, options);
    start(Map.of());
    awaitFailure("player -k");
    rfic.close();
    context.links.clear();
    start(Map.of("key", "wrong"));
    awaitFailure("write the key");
    rfic.close();
    context.links.clear();
    start(Map.of("key", "sesame"));
    await("the right key opens", () -> link() instanceof LinkState.Connected);
  }

  @Test
  void aKilledServerComesBack() throws IOException {
    ServedDevice before = add("power:0", handler("power:0"));
    startConnected();
    want("power:0");
    before.publish(Power.STATE, POWER, STAMP);
    first("power:0");
    int port = server.port();
    server.close();
    await("it is missed", () -> link() instanceof LinkState.Failed);

    context.published.get("power:0").clear();
    clients.clear();
    server = serveAgain(port);
    ServedDevice after = add("power:0", handler("power:0"));
    await("it is back", () -> link() instanceof LinkState.Connected);
    await("what is looked at is open again", () -> clients.getOrDefault("power:0", 0) > 0);
    after.publish(Power.STATE, POWER, STAMP);
    first("power:0");
  }

  @Test
  void aDeviceThatIsGoneIsMissedWhereSomebodyLooks() throws IOException {
    add("power:0", handler("power:0"));
    add("laser:0", handler("laser:0"));
    startConnected();
    want("power:0");
    int port = server.port();
    server.close();
    await("it is missed", () -> link() instanceof LinkState.Failed);
    server = serveAgain(port);
    add("position2d:0", handler("position2d:0"));
    await("the missing one is told", () -> link() instanceof LinkState.Degraded d && d.reason().contains("power:0"));
    await("what nobody looks at goes",
        () -> !context.streams.containsKey("laser:0") && context.streams.containsKey("position2d:0"));
  }

  /** The port may be in use for a moment. */
  private PlayerServer serveAgain(int port) {
    for (int i = 0;; i++) {
      try {
        return serve(port);
      } catch (IOException e) {
        assertTrue(i < 100, e.toString());
        java.util.concurrent.locks.LockSupport.parkNanos(50_000_000);
      }
    }
  }

  @Test
  void aNetworkThatBreaksIsTold() throws IOException {
    try (Hung between = new Hung(server.port())) {
      start(Map.of("port", (long) between.port()));
      await("connected through", () -> link() instanceof LinkState.Connected);
    }
    awaitFailure("127.0.0.1");
  }

  @Test
  void closingEndsAServerThatNeverGreets() throws IOException {
    try (ServerSocket mute = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      start(Map.of("port", (long) mute.getLocalPort()));
      await("it is tried", () -> link() instanceof LinkState.Connecting);
      closesInTime();
    }
  }

  @Test
  void aServerThatHangsIsToldNothingIsSentAndClosingIsBounded() throws IOException {
    ServedDevice device = add("position2d:0", handler("position2d:0"));
    try (Hung between = new Hung(server.port())) {
      start(Map.of("port", (long) between.port()));
      await("connected", () -> link() instanceof LinkState.Connected);
      want("position2d:0");
      for (int i = 0; i < 60; i++) {
        device.publish(Position2d.STATE, STATE, STAMP);
        java.util.concurrent.locks.LockSupport.parkNanos(20_000_000);
      }
      await("it takes velocities",
          () -> send("position2d:0/velocity", VelocityCommand.planar(0.1, 0)) instanceof Sent.Out);
      between.hang();
      await("nothing is sent into the silence",
          () -> send("position2d:0/velocity", VelocityCommand.planar(0.1, 0)) instanceof Sent.Refused r
              && r.reason().contains("not been heard"));
      await("the silence is told", () -> link() instanceof LinkState.Degraded d && d.reason().contains("not answered"));
      closesInTime();
    }
  }

  /** A network between both that can stop to carry anything. */
  private static final class Hung implements AutoCloseable {
    private final ServerSocket listening = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    private final CountDownLatch over = new CountDownLatch(1);
    private volatile boolean hangs;

    Hung(int port) throws IOException {
      DAEMONS.newThread(() -> accept(port)).start();
    }

    int port() {
      return listening.getLocalPort();
    }

    void hang() {
      hangs = true;
    }

    private void accept(int port) {
      try {
        Socket near = listening.accept();
        Socket far = new Socket(InetAddress.getLoopbackAddress(), port);
        DAEMONS.newThread(() -> carry(near, far)).start();
        carry(far, near);
      } catch (IOException e) {
        // the test has ended
      }
    }

    private void carry(Socket from, Socket to) {
      byte[] some = new byte[4096];
      try (from; to) {
        InputStream in = from.getInputStream();
        for (int size = in.read(some); size >= 0 && !hangs; size = in.read(some)) {
          to.getOutputStream().write(some, 0, size);
        }
        if (hangs) {
          over.await();
        }
      } catch (IOException | InterruptedException e) {
        // one side is gone
      }
    }

    @Override
    public void close() throws IOException {
      over.countDown();
      hangs = true;
      listening.close();
    }
  }
}
