package org.robotui.lcm.tests;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.robotui.lcm.Lcm;
import org.robotui.net.thread.Workers;
import org.slf4j.LoggerFactory;

/** One test's programs, in a network of their own where they use multicast. Closing it ends them all. */
final class LcmWorld implements AutoCloseable {

  /** Multicast to a group on the network of this world. */
  static final String GROUP = "udpm://239.255.76.67:7667?ttl=0";

  private static final String NETWORK =
      "ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo"
          + " && echo ready && exec sleep 3600";

  private final Path folder;
  private final List<Peer> peers = new ArrayList<>();
  private final List<String> inside = new ArrayList<>();

  LcmWorld() throws IOException {
    folder = Files.createTempDirectory("robotui-lcm");
  }

  Path folder() {
    return folder;
  }

  /**
   * All programs that are started from now on are in a network where nothing leaves this machine; skips the test if
   * none is to be had.
   */
  void ownNetwork() throws IOException, InterruptedException {
    String reason =
        start("sh", "-c", "unshare --map-root-user --net ip link 2>&1 >/dev/null && ip -V && nsenter -V").finish();
    Assumptions.assumeTrue(reason.contains("iproute") && reason.contains("nsenter"),
        "this machine gives us no network of our own: " + reason);
    ProcessBuilder holder = new ProcessBuilder("unshare", "--map-root-user", "--net", "sh", "-c", NETWORK);
    Process process = holder.redirectErrorStream(true).start();
    Peer network = new Peer("own network", process);
    peers.add(network);
    network.awaitLine("ready");
    inside.addAll(List.of("nsenter", "--preserve-credentials", "-U", "-n", "-t", Long.toString(process.pid())));
  }

  /** Starts a program and does not wait for it. */
  Peer start(String... command) throws IOException {
    List<String> all = new ArrayList<>(inside);
    all.addAll(List.of(command));
    ProcessBuilder builder = new ProcessBuilder(all).directory(folder.toFile()).redirectErrorStream(true);
    builder.environment().remove("LCM_DEFAULT_URL");
    builder.environment().put("PYTHONUNBUFFERED", "1");
    Peer peer = new Peer(String.join(" ", command), builder.start());
    peers.add(peer);
    return peer;
  }

  /** Starts the stock C client: URL, then {@code send CHANNEL SIZES COUNT PAUSE} or {@code receive CHANNELS}. */
  Peer stockC(String... arguments) throws IOException, InterruptedException {
    Path binary = folder.resolve("peer");
    if (!Files.exists(binary)) {
      String output = start("sh", "-c", "gcc -O2 -o peer '" + resource("peer.c") + "' -llcm").finish();
      if (!Files.exists(binary)) {
        throw new AssertionError("the C peer does not compile:\n" + output);
      }
    }
    return ready(binary.toString(), List.of(), arguments);
  }

  /** Starts the stock Java client with the same arguments. */
  Peer stockJava(String... arguments) throws IOException {
    return ready(java(), List.of("-Djava.net.preferIPv4Stack=true", "-cp", LcmInstallation.JAR.toString(),
        resource("StockPeer.java.txt", "StockPeer.java").toString()), arguments);
  }

  /** Starts our client with the same arguments. */
  Peer ours(String... arguments) throws IOException {
    String classPath = Stream.of(OurPeer.class, Lcm.class, Workers.class, LoggerFactory.class).flatMap(LcmWorld::places)
        .map(Path::toString).distinct().collect(Collectors.joining(File.pathSeparator));
    return ready(java(), List.of("-cp", classPath, OurPeer.class.getName()), arguments);
  }

  private static String java() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  private Peer ready(String program, List<String> before, String... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of(program));
    command.addAll(before);
    command.addAll(List.of(arguments));
    return start(command.toArray(String[]::new)).awaitLine("ready");
  }

  /** Where a class comes from: a jar, a folder of classes, or in a framework a bundle's project folder. */
  private static Stream<Path> places(Class<?> type) {
    try {
      Path place = Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
      return Stream.of(place, place.resolve("target/classes"), place.resolve("bin")).filter(Files::exists);
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  Path resource(String name) throws IOException {
    return resource(name, name);
  }

  private Path resource(String name, String as) throws IOException {
    Path file = folder.resolve(as);
    try (InputStream in = LcmWorld.class.getResourceAsStream(name)) {
      Files.write(file, in.readAllBytes());
    }
    return file;
  }

  @Override
  public void close() throws Exception {
    peers.reversed().forEach(Peer::close);
    try (Stream<Path> files = Files.walk(folder)) {
      files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
    }
  }
}
