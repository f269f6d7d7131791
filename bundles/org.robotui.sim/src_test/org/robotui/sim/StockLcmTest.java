package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The stock logger records the simulated robot, stock classes made by lcm-gen decode the record, and the stock library
 * drives.
 */
class StockLcmTest {
  private static final Path JAR = Path.of("/usr/share/java/lcm.jar");
  private static final Map<String, String> COMMON = Map.ofEntries(
      Map.entry("POSE", "pose_t"), Map.entry("ODOMETRY", "odometry_t"), Map.entry("TRANSFORMS", "transforms_t"),
      Map.entry("LASER", "laser_t"),
      Map.entry("IMU", "imu_t"), Map.entry("BATTERY", "battery_t"), Map.entry("CAMERA", "image_t"),
      Map.entry("MAP", "map_t"),
      Map.entry("PATH", "path_t"), Map.entry("GOAL_STATUS", "goal_status_t"), Map.entry("LOG", "log_t"));
  private static final String BIN = Path.of(System.getProperty("java.home"), "bin").toString();

  @TempDir
  private Path folder;
  private final List<Process> started = new ArrayList<>();

  @AfterEach
  void end() {
    started.forEach(Process::destroyForcibly);
  }

  @Test
  void theStockLoggerHearsAllOfNatalieAndTheStockLibraryDrivesHer() throws Exception {
    record("natalie", "SONAR", "ranges_t");
  }

  @Test
  void theStockLoggerHearsAllOfKeiraAndTheStockLibraryDrivesHer() throws Exception {
    record("keira", "BUMPER", "bumper_t");
  }

  private void record(String robot, String ownChannel, String ownType) throws Exception {
    Assumptions.assumeTrue(Files.exists(JAR) && Stream.of("lcm-gen", "lcm-logger").allMatch(StockLcmTest::isThere),
        "LCM is not installed: needs the Debian packages liblcm-bin and liblcm-java");
    Map<String, String> channels = new TreeMap<>(COMMON);
    channels.put(ownChannel, ownType);
    compile();
    Path log = folder.resolve("log");
    Demo demo = Demo
        .start(Options.parse(List.of("--robot", robot, "--speak", "lcm", "--lcm-types", LcmTypes.folder().toString())));
    try (demo) {
      String url = demo.addresses().get("LCM_DEFAULT_URL");
      Assumptions.assumeTrue(url.startsWith("udpm:"), "there is no multicast here");
      Process logger = start("lcm-logger", "--lcm-url=" + url, log.toString());
      Process driver = start(java("drive", url));
      assertEquals(0, exit(driver), output(driver));
      Thread.sleep(5500);
      new ProcessBuilder("kill", "-INT", Long.toString(logger.pid())).start().waitFor();
      exit(logger);
    }
    Path table = folder.resolve("channels");
    Files.write(table, channels.entrySet().stream().map(each -> each.getKey() + "=" + each.getValue()).toList());
    Process reader = start(java("read", log.toString(), table.toString()));
    String text = output(reader);
    assertEquals(0, exit(reader), text);
    Map<String, Double> counts = text.lines().map(line -> line.split(" "))
        .collect(Collectors.toMap(words -> words[0], words -> Double.parseDouble(words[1])));
    assertTrue(counts.keySet().containsAll(channels.keySet()), () -> "only " + counts);
    Set<String> others = Set.of("fastest");
    assertTrue(counts.keySet().stream().allMatch(name -> channels.containsKey(name) || others.contains(name)),
        counts::toString);
    assertTrue(counts.get("ODOMETRY") > 100, counts::toString);
    assertEquals(0.25, counts.get("fastest"), 1e-9);
  }

  private void compile() throws IOException, InterruptedException {
    try (InputStream in = StockLcmTest.class.getResourceAsStream("StockPeer.java.txt");
        Stream<Path> files = Files.list(LcmTypes.folder().resolve("robotui"))) {
      Files.write(folder.resolve("StockPeer.java"), in.readAllBytes());
      List<String> generate = new ArrayList<>(List.of("lcm-gen", "-j", "--jpath", folder.toString()));
      files.map(Path::toString).filter(name -> name.endsWith(".lcm")).forEach(generate::add);
      Process generator = start(generate.toArray(String[]::new));
      assertEquals(0, exit(generator), output(generator));
    }
    List<String> compile = new ArrayList<>(List.of(BIN + "/javac", "-nowarn", "-cp", JAR.toString(), "-d",
        folder.toString(), folder.resolve("StockPeer.java").toString()));
    try (Stream<Path> files = Files.list(folder.resolve("robotui"))) {
      files.map(Path::toString).forEach(compile::add);
    }
    Process compiler = start(compile.toArray(String[]::new));
    String text = output(compiler);
    assertEquals(0, exit(compiler), text);
  }

  private String[] java(String... arguments) {
    List<String> command = new ArrayList<>(
        List.of(BIN + "/java", "-Djava.net.preferIPv4Stack=true", "-cp", JAR + ":" + folder, "StockPeer"));
    command.addAll(List.of(arguments));
    return command.toArray(String[]::new);
  }

  private Process start(String... command) throws IOException {
    Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
    started.add(process);
    return process;
  }

  private static String output(Process process) throws IOException {
    return new String(process.getInputStream().readAllBytes());
  }

  private static int exit(Process process) throws InterruptedException {
    assertTrue(process.waitFor(60, TimeUnit.SECONDS), "it does not end");
    return process.exitValue();
  }

  private static boolean isThere(String tool) {
    try {
      return new ProcessBuilder("sh", "-c", "command -v " + tool).redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .start().waitFor() == 0;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
