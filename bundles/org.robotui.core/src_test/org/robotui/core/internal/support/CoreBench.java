package org.robotui.core.internal.support;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.UicType.Surface;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Match;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;
import org.robotui.core.internal.config.SchemaCheck;
import org.robotui.core.internal.config.YamlConfigSource;
import org.robotui.core.internal.config.YamlOverlay;
import org.robotui.core.internal.host.Core;
import org.robotui.core.internal.host.CoreParts;
import org.robotui.core.internal.host.StateFolder;
import org.robotui.core.internal.life.Registry;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.core.internal.time.WallClock;

/** A whole core with the real reader of configurations, without OSGi. */
public final class CoreBench implements AutoCloseable {
  public final Registry registry = new Registry();
  public final Core core;
  public final List<String> alerts = new CopyOnWriteArrayList<>();
  public final List<String> frames = new CopyOnWriteArrayList<>();
  private final Path folder;

  /** A core that keeps its state in a folder. */
  public CoreBench(Path folder) {
    this.folder = folder;
    core = new Core(new CoreParts(registry, new YamlConfigSource(Map.of()), new SchemaCheck(), new YamlOverlay(),
        new StateFolder(folder.resolve("state")),
        name -> name.startsWith("org.robotui.core.internal.host.") ? Optional.of("org.robotui.uic.bad")
            : Optional.empty(),
        NanoClock.SYSTEM, WallClock.SYSTEM));
    core.open(Surface.WINDOW, Samples.YOU);
    core.listen(new HostListener() {
      @Override
      public void alert(String ruic, String message) {
        alerts.add(message);
      }

      @Override
      public void frameReady(String ruic, String uic) {
        frames.add(uic);
      }
    });
  }

  /** Writes a configuration. */
  public Path write(String yaml) {
    try {
      return Files.writeString(folder.resolve("test.yaml"), yaml);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Loads a configuration. */
  public List<Problem> load(String yaml) {
    return core.load(write(yaml));
  }

  /** The first RUIC, once it runs or has failed. */
  public Ruic ruic() {
    Ruic ruic = core.ruics().getFirst();
    Await.until("the RUIC runs", () -> ruic.snapshot().state() != RuicState.ADDED);
    return ruic;
  }

  /** How a component is doing. */
  public ComponentStatus status(String id) {
    return known(id).orElseThrow();
  }

  private Optional<ComponentStatus> known(String id) {
    return core.ruics().getFirst().snapshot().components().stream().filter(c -> c.id().equals(id)).findFirst();
  }

  /** Waits for a component's state. */
  public void await(String id, RuicState state) {
    Await.until(id + " is " + state, () -> known(id).filter(c -> c.state() == state).isPresent());
  }

  /** What matching says of a port. */
  public Optional<Match> match(String port) {
    return core.ruics().getFirst().snapshot().matches().stream()
        .filter(m -> m.port().toString().equals(port)).findFirst();
  }

  /** Threads of this core that live. */
  public static List<String> threads(String prefix) {
    return Thread.getAllStackTraces().keySet().stream().filter(Thread::isAlive).map(Thread::getName)
        .filter(n -> n.startsWith(prefix)).sorted().toList();
  }

  @Override
  public void close() {
    core.close(Duration.ofSeconds(5));
  }

  /** Asks this process to stop all robots, as another one does; answers what it says. */
  public String stopFromOutside() throws IOException {
    Path socket = folder.resolve("state/run/stop-" + ProcessHandle.current().pid() + ".sock");
    try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket))) {
      Channels.newOutputStream(channel).write("stop\n".getBytes(StandardCharsets.UTF_8));
      return new String(Channels.newInputStream(channel).readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
