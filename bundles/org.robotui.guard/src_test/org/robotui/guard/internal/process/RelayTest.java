package org.robotui.guard.internal.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.guard.internal.wire.Wire;

/** The relay in this process: strangers at its port, and farewells to those who do not hear. */
@Timeout(60)
class RelayTest {
  private static final Limits LIMITS =
      new Limits(Duration.ofMillis(100), Duration.ofSeconds(30), Duration.ofMillis(200), 16, 4,
          Duration.ofMillis(500), Duration.ofSeconds(2));
  private final byte[] knock = new byte[Wire.SECRET];
  private final byte[] answer = new byte[Wire.SECRET];
  private Relay relay;
  private Thread thread;

  @BeforeEach
  void start() throws IOException {
    Arrays.fill(knock, (byte) 1);
    Arrays.fill(answer, (byte) 2);
    relay =
        new Relay(knock, answer, LIMITS, new LineSender(new PrintStream(OutputStream.nullOutputStream())), () -> true);
    thread = new Thread(() -> {
      try {
        relay.run();
      } catch (IOException e) {
        throw new IllegalStateException(e);
      }
    });
    thread.start();
  }

  @AfterEach
  void stop() throws InterruptedException {
    relay.end(true);
    thread.join();
    relay.close();
  }

  private Socket knocking(byte[] bytes) throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), relay.port());
    socket.setSoTimeout(5000);
    socket.getOutputStream().write(bytes);
    return socket;
  }

  private static boolean isClosed(Socket socket) throws IOException {
    try {
      return socket.getInputStream().read() < 0;
    } catch (java.net.SocketTimeoutException e) {
      return false;
    } catch (java.net.SocketException e) {
      return true;
    }
  }

  private byte[] greeting(int port) {
    byte[] greeting = Arrays.copyOf(knock, Wire.SECRET + 1 + 4 + 2 + 4);
    greeting[Wire.SECRET] = 4;
    System.arraycopy(new byte[]{127, 0, 0, 1, (byte) (port >> 8), (byte) port, 0, 0, 20, 0}, 0, greeting,
        Wire.SECRET + 1, 10);
    return greeting;
  }

  @Test
  void strangers_are_left_out_and_told_nothing() throws IOException {
    Random random = new Random(5);
    for (int i = 0; i < 50; i++) {
      byte[] bytes = new byte[Wire.SECRET + random.nextInt(30)];
      random.nextBytes(bytes);
      try (Socket socket = knocking(bytes)) {
        assertTrue(isClosed(socket));
      }
    }
    byte[] wrongAddress = greeting(1);
    wrongAddress[Wire.SECRET] = 7;
    try (Socket socket = knocking(wrongAddress)) {
      assertTrue(isClosed(socket));
    }
  }

  @Test
  void those_who_begin_and_do_not_go_on_do_not_keep_others_out() throws IOException {
    List<Socket> idle = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      idle.add(knocking(new byte[]{1, 1, 1}));
    }
    try (ServerSocket robot = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        Socket ours = knocking(greeting(robot.getLocalPort()))) {
      byte[] reply = ours.getInputStream().readNBytes(Wire.SECRET + 1);
      assertEquals(Wire.DONE, reply[Wire.SECRET]);
      assertTrue(Arrays.equals(answer, Arrays.copyOf(reply, Wire.SECRET)));
    }
    for (Socket socket : idle) {
      assertTrue(isClosed(socket), "after two seconds at most");
      socket.close();
    }
  }

  @Test
  void farewells_to_one_who_is_dead_take_bounded_time_and_others_hear_theirs() throws Exception {
    try (ServerSocket dead = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        ServerSocket hears = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        Socket one = new Socket(dead.getInetAddress(), dead.getLocalPort());
        Socket two = new Socket(dead.getInetAddress(), dead.getLocalPort())) {
      assertTrue(one.isConnected() && two.isConnected());
      byte[] words = "farewell".getBytes(StandardCharsets.UTF_8);
      for (int i = 0; i < 500; i++) {
        relay.keep(i, (InetSocketAddress) dead.getLocalSocketAddress(), words);
      }
      relay.keep(1000, (InetSocketAddress) hears.getLocalSocketAddress(), words);
      relay.keep(1001, (InetSocketAddress) hears.getLocalSocketAddress(), words);
      relay.withdraw(1001);
      long start = System.nanoTime();
      relay.end(false);
      try (Socket heard = hears.accept()) {
        assertEquals("farewell", new String(heard.getInputStream().readNBytes(8), StandardCharsets.UTF_8));
      }
      thread.join();
      double seconds = (System.nanoTime() - start) / 1e9;
      assertTrue(seconds < 10, seconds + " s");
      hears.setSoTimeout(100);
      assertFalse(accepts(hears), "what was withdrawn is not said");
    }
  }

  private static boolean accepts(ServerSocket server) throws IOException {
    try (Socket socket = server.accept()) {
      return true;
    } catch (java.net.SocketTimeoutException e) {
      return false;
    }
  }
}
