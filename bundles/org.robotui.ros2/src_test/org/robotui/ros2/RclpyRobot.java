package org.robotui.ros2;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.robotui.ros2.internal.link.Waiting;

/** A real program of ROS 2, which keeps to this machine. See rclpy_robot.py. */
public final class RclpyRobot implements AutoCloseable {

  private static final Duration START = Duration.ofSeconds(40);
  private static final Duration LONG = Duration.ofSeconds(20);

  private final Process process;
  private final List<String> said = new CopyOnWriteArrayList<>();

  /** Starts it in a domain. */
  public RclpyRobot(int domain) throws IOException {
    Path script = Files.createTempFile("robot", ".py");
    try (var source = RclpyRobot.class.getResourceAsStream("rclpy_robot.py")) {
      Files.write(script, source.readAllBytes());
    }
    Path python = python().orElseThrow();
    String root = python.getParent().getParent().toString();
    ProcessBuilder builder = new ProcessBuilder(python.toString(), script.toString()).redirectErrorStream(true);
    builder.environment().put("ROS_DOMAIN_ID", "" + domain);
    builder.environment().put("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST");
    builder.environment().put("FASTDDS_BUILTIN_TRANSPORTS", "UDPv4");
    builder.environment().put("LD_LIBRARY_PATH", root + "/lib");
    builder.environment().put("AMENT_PREFIX_PATH", root);
    process = builder.start();
    Thread reading = new Thread(() -> read(process.inputReader(StandardCharsets.UTF_8)), "robot");
    reading.setDaemon(true);
    reading.start();
    Waiting.until(START, () -> !process.isAlive(), () -> said.contains("ready"));
    Files.delete(script);
    await("it starts", () -> said.contains("ready"));
  }

  /** The Python of ROS 2, if it is installed. */
  public static Optional<Path> python() {
    return Optional.ofNullable(System.getenv("ROBOTUI_ROS2_PEERS")).map(root -> Path.of(root, "rclpy", "bin/python"))
        .filter(Files::isExecutable);
  }

  private void read(BufferedReader lines) {
    try (lines) {
      lines.lines().forEach(said::add);
    } catch (IOException | UncheckedIOException e) {
      said.add("closed: " + e.getMessage());
    }
  }

  List<String> said() {
    return said;
  }

  /** Waits for something that has to do with it; fails with what it said. */
  public void await(String what, BooleanSupplier condition) {
    if (!Waiting.until(LONG, () -> false, condition)) {
      throw new AssertionError("did not happen: " + what + "; the robot said:\n" + String.join("\n", said));
    }
  }

  /** Ends it without a word to anybody. */
  void kill() throws InterruptedException {
    process.destroyForcibly().waitFor();
  }

  /** Ends it in order. */
  void end() throws IOException, InterruptedException {
    try (var orders = process.outputWriter()) {
      orders.write("end\n");
    }
    process.waitFor(10, TimeUnit.SECONDS);
  }

  @Override
  public void close() throws IOException, InterruptedException {
    if (process.isAlive()) {
      kill();
    }
  }
}
