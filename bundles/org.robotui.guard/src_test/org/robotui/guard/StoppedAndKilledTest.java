package org.robotui.guard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.Socket;
import java.nio.file.Path;
import java.util.concurrent.Executors;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Another process than this one is guarded, stopped and killed. */
@Timeout(90)
class StoppedAndKilledTest {
  private static final int IMAGE = 300_000;
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private Robot robot;
  private Robot master;
  private Process workbench;
  private BufferedReader said;
  private ProcessHandle guard;

  @BeforeEach
  void start() throws Exception {
    robot = new Robot();
    master = new Robot();
    workbench = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx64m", "-cp",
        System.getProperty("java.class.path"),
        Workbench.class.getName(), Integer.toString(robot.address().getPort()),
        Integer.toString(master.address().getPort()))
        .redirectError(ProcessBuilder.Redirect.DISCARD).start();
    said = workbench.inputReader();
    guard = ProcessHandle.of(Long.parseLong(said.readLine())).orElseThrow();
  }

  @AfterEach
  void end() throws IOException {
    workbench.destroyForcibly();
    guard.destroyForcibly();
    robot.close();
    master.close();
    threads.shutdownNow();
  }

  private void signal(String name) throws Exception {
    assertEquals(0, new ProcessBuilder("kill", "-" + name, Long.toString(workbench.pid())).start().waitFor());
  }

  @Test
  void a_stopped_one_holds_nobody_up_and_comes_back() throws Exception {
    Socket link = robot.next();
    Future<Robot.Endured> writing = threads.submit(() -> Robot.drive(link, IMAGE, 50, 12));
    Thread.sleep(500);
    signal("STOP");

    assertEquals("farewell", master.hear());
    Robot.Endured endured = writing.get();

    assertTrue(endured.ended(), "the connection is closed for it");
    assertTrue(endured.longestSeconds() < 0.5, endured.toString());
    signal("CONT");
    Socket again = robot.next();
    Robot.Endured after = Robot.drive(again, IMAGE, 50, 1);
    assertFalse(after.ended(), "it takes again what comes");
    assertFalse(master.isVisited(), "and says no farewell again");
  }

  @Test
  void what_one_that_is_held_up_for_a_moment_had_is_not_lost() throws Exception {
    Socket link = robot.next();
    Future<Robot.Endured> writing = threads.submit(() -> Robot.drive(link, 10_000, 50, 4));
    Thread.sleep(500);
    signal("STOP");
    Thread.sleep(1000);
    signal("CONT");

    assertEquals(new Robot.Endured(0, false).ended(), writing.get().ended());
    assertFalse(master.isVisited());
    assertFalse(robot.isVisited(), "no new connection was needed");
  }

  @Test
  void a_killed_one_is_left_at_once_and_so_is_the_guard() throws Exception {
    Socket link = robot.next();
    Future<Robot.Endured> writing = threads.submit(() -> Robot.drive(link, IMAGE, 50, 12));
    workbench.destroyForcibly();

    assertEquals("farewell", master.hear());
    assertTrue(writing.get().ended());
    assertTrue(writing.get().longestSeconds() < 0.5, writing.get().toString());
    GuardTest.eventually(() -> !guard.isAlive(), "the end of the guard");
  }

  @Test
  void one_that_is_stopped_and_then_killed_leaves_nothing() throws Exception {
    robot.next();
    signal("STOP");
    assertEquals("farewell", master.hear());
    workbench.destroyForcibly();
    GuardTest.eventually(() -> !guard.isAlive(), "the end of the guard");
  }
}
