package org.robotui.smartsoft;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.robotui.smartsoft.wire.SmartFrame;
import org.robotui.smartsoft.wire.SmartFraming;

/** Recorded sessions of ACE/SmartSoft, shared beside the repository; tests that need them are skipped without them. */
final class SmartCaptures {

  /** Links between components and their naming service. */
  static final List<String> NAMING = List.of("ns_push_server", "ns_push_client", "ns_event_server", "ns_event_client",
      "ns_send_server", "ns_send_client", "ns_query_server", "ns_query_client");
  /** Links between clients and servers of services. */
  static final List<String> SERVICES = List.of("push", "event_morethan", "event_morethan2", "event_interval", "send_a",
      "send_b1", "send_b2", "query_time", "query_calc");

  private SmartCaptures() {}

  /** The files of all links, with both directions of each. */
  static Stream<String> files() {
    return Stream.concat(NAMING.stream(), SERVICES.stream()).flatMap(link -> Stream.of(link + ".c2s", link + ".s2c"));
  }

  static byte[] bytes(String file) {
    Optional<Path> found = root().map(root -> root.resolve("captures/smartsoft").resolve(file + ".bin"))
        .filter(Files::isReadable);
    Assumptions.assumeTrue(found.isPresent(), "no recorded SmartSoft session " + file + " (set ROBOTUI_SHARED)");
    try {
      return Files.readAllBytes(found.orElseThrow());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static List<SmartFrame> frames(String file) {
    ByteArrayInputStream in = new ByteArrayInputStream(bytes(file));
    List<SmartFrame> frames = new ArrayList<>();
    try {
      while (in.available() > 0) {
        frames.add(new SmartFraming().read(in));
      }
      return frames;
    } catch (IOException e) {
      throw new AssertionError(file + " after " + frames.size() + " frames", e);
    }
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
