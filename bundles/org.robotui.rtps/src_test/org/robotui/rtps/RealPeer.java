package org.robotui.rtps;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;

/** A real program of another vendor, which keeps to loopback. See rclpy_peer.py for its orders. */
final class RealPeer implements AutoCloseable {

  private static final Duration START = Duration.ofSeconds(40);
  private static final String CYCLONE =
      "<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast><Interfaces>"
          + "<NetworkInterface name=\"lo\" multicast=\"false\"/></Interfaces></General><Discovery><ParticipantIndex>auto"
          + "</ParticipantIndex><MaxAutoParticipantIndex>30</MaxAutoParticipantIndex><Peers><Peer address=\"127.0.0.1\"/>"
          + "</Peers></Discovery></Domain></CycloneDDS>";

  private final Process process;
  private final Writer orders;
  private final List<String> said = new CopyOnWriteArrayList<>();

  /** Whose library it is. */
  enum Vendor {
    FAST_DDS("rclpy"), CYCLONE("cyclone");

    private final String folder;

    Vendor(String folder) {
      this.folder = folder;
    }

    /** Its Python, if it is installed: ./robotui test does so. */
    Optional<Path> python() {
      return Optional.ofNullable(System.getenv("ROBOTUI_ROS2_PEERS")).map(root -> Path.of(root, folder, "bin/python"))
          .filter(Files::isExecutable);
    }
  }

  /** Hears the topic {@code to_peer} and writes {@code from_peer}, with these: reliability, durability, history. */
  RealPeer(Vendor vendor, int domain, String... qos) throws IOException, InterruptedException {
    this(vendor, domain, List.of("to_peer", "from_peer"), qos);
  }

  private RealPeer(Vendor vendor, int domain, List<String> topics, String... qos)
      throws IOException, InterruptedException {
    Path script = Files.createTempFile("peer", ".py");
    try (var source = RealPeer.class.getResourceAsStream(vendor.folder + "_peer.py")) {
      Files.write(script, source.readAllBytes());
    }
    Path python = vendor.python().orElseThrow();
    Path root = python.getParent().getParent();
    List<String> command = new ArrayList<>(List.of(python.toString(), script.toString()));
    command.addAll(List.of(qos));
    command.add("" + domain);
    command.addAll(topics);
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().put("ROS_DOMAIN_ID", "" + domain);
    builder.environment().put("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST");
    builder.environment().put("FASTDDS_BUILTIN_TRANSPORTS", "UDPv4");
    builder.environment().put("LD_LIBRARY_PATH", root.resolve("lib").toString());
    builder.environment().put("AMENT_PREFIX_PATH", root.toString());
    builder.environment().put("CYCLONEDDS_URI", CYCLONE);
    process = builder.start();
    orders = process.outputWriter(StandardCharsets.UTF_8);
    Thread reading = new Thread(() -> read(process.inputReader(StandardCharsets.UTF_8)), "peer");
    reading.setDaemon(true);
    reading.start();
    Heard.await(START, () -> said.contains("ready") || !process.isAlive(), () -> "no start: " + said);
    Files.delete(script);
    if (!said.contains("ready")) {
      throw new IOException("it ended by itself: " + said);
    }
  }

  /** Hears what another one writes. */
  static RealPeer witness(Vendor vendor, int domain, String... qos) throws IOException, InterruptedException {
    return new RealPeer(vendor, domain, List.of("from_peer", "from_witness"), qos);
  }

  private void read(BufferedReader lines) {
    try (lines) {
      lines.lines().forEach(said::add);
    } catch (IOException | UncheckedIOException e) {
      said.add("closed: " + e.getMessage());
    }
  }

  /** Writes strings, and does not wait for that. */
  void write(int count, int size, double period) throws IOException {
    orders.write("write " + count + " " + size + " " + period + "\n");
    orders.flush();
  }

  /** Waits until it hears so many writers, and so many readers hear it: what is said before is lost to them. */
  void meet(int writers, int readers) throws IOException, InterruptedException {
    int before = said("met").size();
    orders.write("meet " + writers + " " + readers + "\n");
    orders.flush();
    Heard.await(START, () -> said("met").size() > before, () -> "nobody met: " + said);
  }

  /** The words that begin what it heard. */
  List<String> heard() {
    return said.stream().filter(line -> line.startsWith("heard ")).map(line -> line.split(" ")[1]).toList();
  }

  /** Lines that begin with a word. */
  List<String> said(String word) {
    return said.stream().filter(line -> line.startsWith(word)).toList();
  }

  /** Ends it without a word to anybody. */
  void kill() throws InterruptedException {
    process.destroyForcibly().waitFor();
  }

  @Override
  public void close() throws IOException, InterruptedException {
    if (process.isAlive()) {
      orders.write("end\n");
      orders.flush();
      if (!process.waitFor(10, TimeUnit.SECONDS)) {
        kill();
      }
    }
  }

  @Override
  public String toString() {
    List<String> all = List.copyOf(said);
    return "" + all.subList(Math.max(0, all.size() - 20), all.size());
  }
}
