package org.robotui.core.tests;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assertions;

/** The demo's robot, a process of its own that goes on while the bundles here come and go. */
final class Simulator implements AutoCloseable {
  private static final String ADDRESS = "ROS_MASTER_URI=";
  private static final int END_SECONDS = 5;

  private final Process process;
  private final String master;

  Simulator() throws IOException {
    String classes = Stream.of("org.robotui.sim", "org.robotui.ros", "org.robotui.geometry", "slf4j.api")
        .map(Bundles::file).map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    process = new ProcessBuilder(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        "-XX:TieredStopAtLevel=1", "-Xmx128m", "-cp", classes, "org.robotui.sim.Main",
        "--parent", Long.toString(ProcessHandle.current().pid())))
        .redirectError(ProcessBuilder.Redirect.DISCARD).start();
    master = address();
  }

  private String address() throws IOException {
    BufferedReader out = process.inputReader();
    String line = String.valueOf(out.readLine());
    Assertions.assertTrue(line.startsWith(ADDRESS), "the simulator says " + line);
    return line.substring(ADDRESS.length());
  }

  /** The address of its master. */
  String master() {
    return master;
  }

  @Override
  public void close() throws Exception {
    process.destroy();
    if (!process.waitFor(END_SECONDS, TimeUnit.SECONDS)) {
      process.destroyForcibly();
    }
  }
}
