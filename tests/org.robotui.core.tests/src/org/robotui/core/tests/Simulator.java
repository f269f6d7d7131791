package org.robotui.core.tests;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assertions;

/** The demo's robot, a process of its own that goes on while the bundles here come and go. */
final class Simulator implements AutoCloseable {
  /** The types of messages that it speaks over LCM; tests run in their project's folder. */
  static final Path LCM_TYPES = Path.of("../../configs/lcm/types").toAbsolutePath().normalize();

  private static final int END_SECONDS = 5;

  private final Process process;
  private final BufferedReader out;
  private final Map<String, String> addresses = new HashMap<>();

  /** Speaks ROS, or what the options say. */
  Simulator(String... options) throws IOException {
    String classes = Stream
        .of("org.robotui.sim", "org.robotui.ros", "org.robotui.message", "org.robotui.player", "org.robotui.lcm",
            "org.robotui.ros2", "org.robotui.rtps", "org.robotui.carmen", "org.robotui.yarp", "org.robotui.smartsoft",
            "org.robotui.net", "org.robotui.geometry", "slf4j.api")
        .map(Bundles::file).map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        "-XX:TieredStopAtLevel=1", "-Xmx128m", "-cp", classes, "org.robotui.sim.Main",
        "--parent", Long.toString(ProcessHandle.current().pid())));
    command.addAll(List.of(options));
    process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    out = process.inputReader();
  }

  /** The address of which it says that it is in this variable. */
  String address(String variable) throws IOException {
    while (!addresses.containsKey(variable)) {
      String[] said = String.valueOf(out.readLine()).split("=", 2);
      Assertions.assertEquals(2, said.length, "the simulator does not say where " + variable + " is, but " + addresses);
      addresses.put(said[0], said[1]);
    }
    return addresses.get(variable);
  }

  /** Host and port as settings, from an address of the form HOST:PORT that this variable has. */
  String hostAndPort(String variable) throws IOException {
    String[] parts = address(variable).split(":");
    return "host: '" + parts[0] + "', port: " + parts[1];
  }

  @Override
  public void close() throws Exception {
    process.destroy();
    if (!process.waitFor(END_SECONDS, TimeUnit.SECONDS)) {
      process.destroyForcibly();
    }
  }
}
