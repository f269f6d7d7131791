package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.Vector3;
import org.robotui.message.RecordCodec;
import org.robotui.net.thread.Workers;
import org.robotui.ros.RosNode;
import org.slf4j.LoggerFactory;

/** The demo as a process of its own. */
class MainTest {
  private final List<Process> started = new ArrayList<>();

  @AfterEach
  void killAll() {
    started.forEach(Process::destroyForcibly);
  }

  private Process start(ProcessBuilder builder) throws IOException {
    Process process = builder.start();
    started.add(process);
    return process;
  }

  /** Where the classes of this test come from, however they were loaded. */
  private static String classPath() {
    return Stream.of(Main.class, RosNode.class, RecordCodec.class, Workers.class, Vector3.class, LoggerFactory.class)
        .map(type -> Path.of(URI.create(type.getProtectionDomain().getCodeSource().getLocation().toString())))
        .map(Path::toString)
        .distinct()
        .collect(Collectors.joining(File.pathSeparator));
  }

  private Process startDemo(String... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of(
        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        "-cp", classPath(), Main.class.getName()));
    command.addAll(List.of(arguments));
    return start(new ProcessBuilder(command).redirectError(new File("/dev/null")));
  }

  @Test
  void itPrintsItsAddressAndNothingElseAndEndsWhenToldTo() throws Exception {
    Process demo = startDemo();
    try (BufferedReader out = demo.inputReader()) {
      String line = String.valueOf(out.readLine());
      assertTrue(line.matches("ROS_MASTER_URI=http://127\\.0\\.0\\.1:\\d+"), line);
      long before = System.nanoTime();
      demo.toHandle().destroy();
      assertTrue(demo.waitFor(30, TimeUnit.SECONDS));
      long millis = (System.nanoTime() - before) / 1_000_000;
      assertTrue(millis < 8000, "ended after " + millis + " ms");
      assertNull(out.readLine());
    }
  }

  @Test
  void itEndsWithItsParent() throws Exception {
    Process parent = start(new ProcessBuilder("sleep", "600"));
    Process demo = startDemo("--parent", Long.toString(parent.pid()));
    try (BufferedReader out = demo.inputReader()) {
      assertTrue(String.valueOf(out.readLine()).startsWith("ROS_MASTER_URI="));
      assertTrue(demo.isAlive());
      parent.destroyForcibly();
      assertTrue(demo.waitFor(10, TimeUnit.SECONDS));
    }
  }

  @Test
  void mistakesEndItAtOnce() throws Exception {
    Process demo = startDemo("--colour", "red");
    assertTrue(demo.waitFor(20, TimeUnit.SECONDS));
    assertEquals(2, demo.exitValue());
  }
}
