package org.robotui.player;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Assumptions;
import org.robotui.player.wire.Framing;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** Recorded sessions of a real server, shared beside the repository; tests that need them are skipped without them. */
public final class Captures {

  /** The recorded connections. */
  public static final List<String> NAMES = List.of("position2d", "errors", "rangers", "two_devices_pull",
      "simulation_map_properties", "log",
      "bumper", "everything_robot0", "everything_robot1", "everything_robot2_list", "dummy_devices", "dummy_camera");

  private Captures() {}

  /** A file of the recordings. */
  public static Path file(String name) {
    Optional<Path> found = root().map(root -> root.resolve("captures/player").resolve(name)).filter(Files::isReadable);
    Assumptions.assumeTrue(found.isPresent(), "no recorded Player session " + name + " (set ROBOTUI_SHARED)");
    return found.orElseThrow();
  }

  /** All bytes of a file of the recordings. */
  public static byte[] bytes(String name) {
    try {
      return Files.readAllBytes(file(name));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** What the client said. */
  public static List<PlayerMessage> fromClient(String connection) {
    return messages(new ByteArrayInputStream(bytes(connection + ".c2s.bin")));
  }

  /** What the server said after its greeting. */
  public static List<PlayerMessage> fromServer(String connection) {
    ByteArrayInputStream in = new ByteArrayInputStream(bytes(connection + ".s2c.bin"));
    in.skip(PlayerMessage.BANNER_BYTES);
    return messages(in);
  }

  private static List<PlayerMessage> messages(ByteArrayInputStream in) {
    List<PlayerMessage> messages = new ArrayList<>();
    try {
      while (in.available() > 0) {
        messages.add(Framing.read(in));
      }
    } catch (IOException | PlayerException e) {
      throw new AssertionError("after " + messages.size() + " messages", e);
    }
    return messages;
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
