package org.robotui.yarp;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;

/** Recorded sessions of YARP 3.9.1, shared beside the repository; tests that need them are skipped without them. */
public final class YarpCaptures {

  /** Connections by tcp and fast_tcp from robots. */
  public static final List<String> FROM_ROBOT = List.of("b_to_ui_laser_tcp", "b_to_ui_laserfast_fasttcp",
      "b_to_ui_imu_tcp", "b_to_ui_state_tcp", "b_to_ui_stateExt_tcp", "b_to_ui_cam_tcp", "b_to_ui_read_tcp",
      "b_to_ui_read_tcp2", "b_to_ui_read_tcp3");

  /** Connections by tcp to robots and to the name server. */
  public static final List<String> TO_ROBOT = List.of("a_ns_tcp", "b_board_rpc_i_tcp", "b_board_rpc_i_tcp2",
      "b_board_rpc_i_tcp3", "b_board_command_i_tcp");

  private YarpCaptures() {}

  /** All bytes of a file of the recordings. */
  public static byte[] bytes(String name) {
    Optional<Path> found = root().map(root -> root.resolve("captures/yarp").resolve(name)).filter(Files::isReadable);
    Assumptions.assumeTrue(found.isPresent(), "no recorded YARP session " + name + " (set ROBOTUI_SHARED)");
    try {
      return Files.readAllBytes(found.orElseThrow());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** What who connected said, behind its header. */
  public static List<YarpMessage> messages(String connection) {
    try {
      ByteArrayInputStream in = new ByteArrayInputStream(bytes(connection + ".c2s.bin"));
      YarpFraming.readHeader(in);
      List<YarpMessage> messages = new ArrayList<>();
      while (in.available() > 0) {
        messages.add(YarpFraming.read(in));
      }
      return messages;
    } catch (IOException e) {
      throw new AssertionError(connection, e);
    }
  }

  /** The bottles in them. */
  public static List<Bottle> bottles(String connection) {
    return messages(connection).stream().filter(m -> m.data().length > 0).map(m -> {
      try {
        return BottleCodec.read(m.data());
      } catch (IOException e) {
        throw new AssertionError(connection, e);
      }
    }).toList();
  }

  /** All files of text connections, without their ends. */
  public static List<String> texts() {
    bytes("connections.csv");
    try (Stream<Path> files = Files.list(root().orElseThrow().resolve("captures/yarp"))) {
      return files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(".s2c.bin"))
          .map(name -> name.replace(".s2c.bin", "")).filter(name -> !name.contains("tcp")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The lines of a file. */
  public static List<String> lines(String name) {
    return new String(bytes(name), StandardCharsets.UTF_8).lines().toList();
  }

  private static Optional<Path> root() {
    String configured = System.getenv("ROBOTUI_SHARED");
    return configured != null
        ? Optional.of(Path.of(configured))
        : repository().map(repository -> repository.resolveSibling("shared"));
  }

  private static Optional<Path> repository() {
    Path folder = Path.of("").toAbsolutePath();
    while (folder != null && !Files.isDirectory(folder.resolve("bundles"))) {
      folder = folder.getParent();
    }
    return Optional.ofNullable(folder);
  }
}
