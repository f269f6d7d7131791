package org.robotui.ros.tests;

import java.io.IOException;
import java.io.InputStream;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;
import java.util.stream.Stream;
import org.robotui.ros.GraphName;
import org.robotui.ros.LinkListener;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;

/** One test's ROS graph on a free loopback port: real processes and our nodes. Closing it ends them all. */
final class RosWorld implements AutoCloseable {

  private final Path folder;
  private final int port;
  private final List<AutoCloseable> ours = new ArrayList<>();
  private final List<Peer> peers = new ArrayList<>();

  RosWorld() throws IOException {
    folder = Files.createTempDirectory("robotui-ros");
    port = freePort();
  }

  /** Below the ports that the system hands out by itself: until a slow peer binds it, nobody else gets it by chance. */
  private static int freePort() throws IOException {
    for (int attempt = 0; attempt < 100; attempt++) {
      try (ServerSocket free =
          new ServerSocket(ThreadLocalRandom.current().nextInt(15_000, 32_000), 1, InetAddress.getLoopbackAddress())) {
        return free.getLocalPort();
      } catch (BindException e) {
        continue; // in use
      }
    }
    throw new IOException("no free port between 15000 and 32000");
  }

  URI masterUri() {
    return URI.create("http://127.0.0.1:" + port + "/");
  }

  Path folder() {
    return folder;
  }

  /** Starts our own master. */
  RosMaster ourMaster() throws IOException {
    RosMaster master = RosMaster.open(MasterOptions.standard(RosWorld::thread).withPort(port));
    ours.add(master);
    return master;
  }

  /** Starts roscore with all that belongs to it. */
  Peer roscore() throws IOException {
    return start("roscore", "-p", Integer.toString(port)).awaitLine("started core service");
  }

  /** Starts the real master alone: one process, so that killing it is simple. */
  Peer rosmaster() throws IOException {
    Peer master = start("rosmaster", "--core", "-p", Integer.toString(port));
    Eventually.await("the real master", () -> {
      try (java.net.Socket socket = new java.net.Socket(InetAddress.getByName("127.0.0.1"), port)) {
        return socket.isConnected();
      } catch (IOException e) {
        return false;
      }
    });
    return master;
  }

  /** Starts one of the Python peers that lie beside this class and waits until it is ready. */
  Peer python(String script, String... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of("/usr/bin/python3", resource(script).toString()));
    command.addAll(List.of(arguments));
    return start(command.toArray(String[]::new)).awaitLine("ready");
  }

  /** Starts the roscpp peer and waits until it is ready. */
  Peer roscpp(String role, String node, String name) throws IOException, InterruptedException {
    Path binary = folder.resolve("peer");
    if (!Files.exists(binary)) {
      String compile = "g++ -O1 -o '" + binary + "' '" + resource("peer.cpp")
          + "' $(pkg-config --cflags --libs roscpp std_msgs std_srvs)";
      String output = start("sh", "-c", compile).finish();
      if (!Files.exists(binary)) {
        throw new AssertionError("the roscpp peer does not compile:\n" + output);
      }
    }
    return start(binary.toString(), role, node, name).awaitLine("ready");
  }

  /** Runs a stock tool to its end and answers what it printed. */
  String tool(String... command) throws IOException, InterruptedException {
    return start(command).finish();
  }

  Peer start(String... command) throws IOException {
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().put("ROS_MASTER_URI", masterUri().toString());
    builder.environment().put("ROS_IP", "127.0.0.1");
    builder.environment().put("ROS_HOME", folder.resolve("home").toString());
    builder.environment().put("PYTHONUNBUFFERED", "1");
    builder.environment().remove("ROS_HOSTNAME");
    Peer peer = new Peer(builder);
    peers.add(peer);
    return peer;
  }

  RosNode node(String name) throws IOException {
    return node(name, LinkListener.none());
  }

  RosNode node(String name, LinkListener links) throws IOException {
    NodeOptions options = NodeOptions.standard(RosWorld::thread).withLinks(links)
        .withTimes(Duration.ofSeconds(5), Duration.ofMillis(500), Duration.ofSeconds(1));
    RosNode node = RosNode.open(RosEnvironment.of(masterUri()), GraphName.of(name), options);
    ours.add(node);
    return node;
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work);
    thread.setDaemon(true);
    return thread;
  }

  Path resource(String name) throws IOException {
    Path file = folder.resolve(name);
    try (InputStream in = RosWorld.class.getResourceAsStream(name)) {
      Files.write(file, in.readAllBytes());
    }
    return file;
  }

  @Override
  public void close() throws Exception {
    for (int i = ours.size() - 1; i >= 0; i--) {
      ours.get(i).close();
    }
    peers.forEach(Peer::close);
    try (Stream<Path> files = Files.walk(folder)) {
      files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
    }
  }
}
