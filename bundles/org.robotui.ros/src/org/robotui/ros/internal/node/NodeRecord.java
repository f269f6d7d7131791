package org.robotui.ros.internal.node;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import org.robotui.net.process.RunningProcess;

/**
 * What is written down of a node so that its registrations can be removed when its process was killed.
 *
 * @param node its global name
 * @param uri the address of its own API
 * @param rpcUri the address of its services
 * @param master the address of the master
 * @param owner who it belongs to
 * @param parameters the parameters it listens to, which masters do not tell
 */
record NodeRecord(String node, String uri, String rpcUri, String master, Owner owner, List<String> parameters) {

  static final String SUFFIX = ".rosnode";
  private static final int MAX_BYTES = 64 * 1024;

  NodeRecord withParameters(List<String> keys) {
    return new NodeRecord(node, uri, rpcUri, master, owner, List.copyOf(keys));
  }

  /** Writes it so that a reader finds the whole or nothing. */
  void write(Path file) throws IOException {
    Properties all = new Properties();
    all.setProperty("node", node);
    all.setProperty("uri", uri);
    all.setProperty("rpc_uri", rpcUri);
    all.setProperty("master", master);
    all.setProperty("host", owner.host());
    all.setProperty("pid", Long.toString(owner.process().pid()));
    all.setProperty("started", Long.toString(owner.process().started().toEpochMilli()));
    all.setProperty("parameters", String.join(" ", parameters));
    StringWriter text = new StringWriter();
    all.store(text, "registered at a ROS master; removed when the node is closed");
    Path part = file.resolveSibling(file.getFileName() + ".part");
    try {
      Files.writeString(part, text.toString());
      Files.move(part, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(part);
    }
  }

  static NodeRecord read(Path file) throws IOException {
    if (Files.size(file) > MAX_BYTES) {
      throw new IOException("it is longer than " + MAX_BYTES + " bytes");
    }
    Properties all = new Properties();
    try {
      all.load(new StringReader(new String(Files.readAllBytes(file), StandardCharsets.UTF_8)));
      Owner owner = new Owner(get(all, "host"), new RunningProcess(Long.parseLong(get(all, "pid")),
          Instant.ofEpochMilli(Long.parseLong(get(all, "started")))));
      List<String> parameters =
          List.of(get(all, "parameters").split(" ")).stream().filter(key -> !key.isEmpty()).toList();
      return new NodeRecord(get(all, "node"), get(all, "uri"), get(all, "rpc_uri"), get(all, "master"), owner,
          parameters);
    } catch (IllegalArgumentException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private static String get(Properties all, String key) throws IOException {
    return Optional.ofNullable(all.getProperty(key)).orElseThrow(() -> new IOException("'" + key + "' is missing"));
  }
}
