package org.robotui.guard;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A guard as its users see it: a real process. */
@Timeout(120)
class GuardTest {
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private Guard guard;
  private Robot robot;

  @BeforeEach
  void open() throws IOException {
    guard = new Guards().open();
    robot = new Robot();
  }

  @AfterEach
  void close() throws IOException {
    robot.close();
    guard.close();
    threads.shutdownNow();
  }

  private Socket connect() throws IOException {
    Socket socket = guard.sockets().createSocket();
    socket.connect(robot.address(), 5000);
    return socket;
  }

  static void eventually(BooleanSupplier condition, String what) throws InterruptedException {
    long end = System.nanoTime() + 30_000_000_000L;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, what);
      Thread.sleep(20);
    }
  }

  @Test
  void what_is_sent_comes_unchanged_both_ways() throws Exception {
    byte[] much = new byte[20 << 20];
    new Random(1).nextBytes(much);
    try (Socket ours = connect(); Socket theirs = robot.next()) {
      assertEquals(robot.address(), ours.getRemoteSocketAddress());
      Future<byte[]> received = threads.submit(() -> ours.getInputStream().readNBytes(much.length));
      theirs.getOutputStream().write(much);
      assertArrayEquals(much, received.get());

      Future<byte[]> back = threads.submit(() -> theirs.getInputStream().readNBytes(1 << 20));
      ours.getOutputStream().write(much, 0, 1 << 20);
      assertArrayEquals(Arrays.copyOf(much, 1 << 20), back.get());
    }
    assertEquals(0, guard.state().overflows());
  }

  @Test
  void many_connections_at_once_are_kept_apart() throws Exception {
    List<Future<?>> echoes = new ArrayList<>();
    List<Callable<Boolean>> all = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      int number = i;
      Socket ours = connect();
      Socket theirs = robot.next();
      echoes.add(threads.submit(() -> theirs.getInputStream().transferTo(theirs.getOutputStream())));
      all.add(() -> {
        byte[] said = ("number " + number + " ").repeat(2000).getBytes(StandardCharsets.UTF_8);
        Future<?> saying = threads.submit(() -> {
          ours.getOutputStream().write(said);
          return true;
        });
        byte[] heard = ours.getInputStream().readNBytes(said.length);
        saying.get();
        ours.close();
        return Arrays.equals(said, heard);
      });
    }
    for (Future<Boolean> same : threads.invokeAll(all)) {
      assertTrue(same.get());
    }
    for (Future<?> echo : echoes) {
      echo.get();
    }
  }

  @Test
  void last_words_come_before_the_end() throws Exception {
    Socket ours = connect();
    Socket theirs = robot.next();
    ours.getOutputStream().write("stop".getBytes(StandardCharsets.UTF_8));
    ours.close();
    theirs.setSoTimeout(5000);
    assertEquals("stop", new String(theirs.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
  }

  @Test
  void the_end_of_the_robot_is_our_end_after_its_last_words() throws Exception {
    try (Socket ours = connect()) {
      Socket theirs = robot.next();
      theirs.getOutputStream().write(new byte[300_000]);
      theirs.close();
      ours.setSoTimeout(5000);
      assertEquals(300_000, ours.getInputStream().readAllBytes().length);
    }
  }

  @Test
  void a_robot_that_is_not_there_is_said_to_be_so() throws Exception {
    InetSocketAddress address = robot.address();
    robot.close();
    try (Socket socket = guard.sockets().createSocket()) {
      assertTrue(
          assertThrows(ConnectException.class, () -> socket.connect(address, 3000)).getMessage().contains("refused"));
    }
  }

  @Test
  void a_robot_that_does_not_answer_is_waited_for_as_long_as_asked() throws Exception {
    try (ServerSocket deaf = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      List<Socket> filling = new ArrayList<>();
      for (int i = 0; i < 2; i++) {
        filling.add(new Socket(deaf.getInetAddress(), deaf.getLocalPort()));
      }
      long start = System.nanoTime();
      try (Socket socket = guard.sockets().createSocket()) {
        assertThrows(SocketTimeoutException.class, () -> socket.connect(deaf.getLocalSocketAddress(), 700));
      }
      double seconds = (System.nanoTime() - start) / 1e9;
      assertTrue(seconds > 0.6 && seconds < 10, seconds + " s");
      for (Socket socket : filling) {
        socket.close();
      }
    }
  }

  @Test
  void a_consumer_that_takes_nothing_holds_the_robot_up_for_half_a_second_at_most() throws Exception {
    try (Socket slow = connect(); Socket theirs = robot.next(); Socket good = connect(); Socket other = robot.next()) {
      Future<Robot.Endured> innocent = threads.submit(() -> Robot.drive(other, 1000, 10, 3));
      Future<?> taking = threads.submit(() -> good.getInputStream().transferTo(OutputStream.nullOutputStream()));

      Robot.Endured endured = Robot.drive(theirs, 1 << 20, 5, 20);

      assertTrue(endured.ended(), "the connection is given up");
      assertTrue(endured.longestSeconds() < 1.0, endured.toString());
      eventually(() -> guard.state().overflows() == 1, "the count");
      assertFalse(innocent.get().ended(), "others go on");
      assertTrue(innocent.get().longestSeconds() < 0.5, innocent.get().toString());
      other.close();
      taking.get();
      InputStream in = slow.getInputStream();
      slow.setSoTimeout(5000);
      try {
        in.transferTo(OutputStream.nullOutputStream()); // what was under way, and then the end
      } catch (SocketTimeoutException e) {
        throw new AssertionError("the end is not told", e);
      } catch (IOException e) {
        // reset
      }
    }
  }

  @Test
  void a_guard_that_is_killed_is_started_again_and_remembers_what_to_say() throws Exception {
    guard.farewell(robot.address(), "farewell".getBytes(StandardCharsets.UTF_8));
    Socket ours = connect();
    robot.next();
    long pid = guard.state().pid();

    ProcessHandle.of(pid).orElseThrow().destroyForcibly();

    ours.setSoTimeout(5000);
    try {
      assertEquals(-1, ours.getInputStream().read());
    } catch (SocketException e) {
      // reset: it is lost, too
    }
    eventually(() -> guard.state().starts() == 2 && guard.state().pid() != 0, "the next guard");
    assertNotEquals(pid, guard.state().pid());
    assertFalse(robot.isVisited(), "a farewell was said though we are here");
    try (Socket again = connect(); Socket theirs = robot.next()) {
      theirs.getOutputStream().write(7);
      assertEquals(7, again.getInputStream().read());
    }
  }

  @Test
  void a_guard_that_hangs_is_replaced() throws Exception {
    long pid = guard.state().pid();
    new ProcessBuilder("kill", "-STOP", Long.toString(pid)).start().waitFor();
    long end = System.nanoTime() + 40_000_000_000L;
    while (guard.state().starts() < 2 && System.nanoTime() < end) {
      Thread.sleep(50);
    }
    eventually(() -> guard.state().pid() != 0, "the next guard");
    assertNotEquals(pid, guard.state().pid());
    eventually(() -> !ProcessHandle.of(pid).map(ProcessHandle::isAlive).orElse(false), "the end of the one that hangs");
  }

  @Test
  void the_process_ends_with_its_last_user_and_says_nothing() throws Exception {
    Guards guards = new Guards();
    Guard one = guards.open();
    Guard two = guards.open();
    one.farewell(robot.address(), "farewell".getBytes(StandardCharsets.UTF_8));
    ProcessHandle process = ProcessHandle.of(one.state().pid()).orElseThrow();
    assertEquals(one.state().pid(), two.state().pid());
    one.close();
    assertTrue(process.isAlive());
    two.close();
    assertFalse(process.isAlive());
    assertFalse(robot.isVisited());
    try (Socket late = one.sockets().createSocket()) {
      assertThrows(IOException.class, () -> late.connect(robot.address()));
    }
  }
}
