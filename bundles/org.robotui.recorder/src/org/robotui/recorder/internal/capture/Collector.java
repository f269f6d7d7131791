package org.robotui.recorder.internal.capture;

import java.time.Duration;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.robotui.api.command.Principal;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Host;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.port.Intake;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.api.record.RecordingChoice;
import org.robotui.net.thread.Uninterruptibles;
import org.robotui.recorder.internal.capture.HeadTable.Place;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Takes what robots send, on a thread of its own, so that the threads that receive it never wait for a disk: they leave
 * it in the boxes that core keeps for each consumer, which are looked into often enough.
 */
public final class Collector implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Collector.class);
  private static final Principal WHO = new Principal("recorder", "The recorder", Principal.Kind.SCRIPT);
  private static final long SCAN_NANOS = 300_000_000L;
  private static final long LONGEST_PAUSE = 50_000_000L;
  private static final Duration END = Duration.ofSeconds(10);

  private record TapKey(Ruic ruic, SourceId port) {}

  private final Host host;
  private final NamePatterns robots;
  private final NamePatterns ports;
  private final StreamTap.Shared shared;
  private final EventWatch events;
  private final Host.Subscription faults;
  private final Map<Ruic, PortAccess> accesses = new IdentityHashMap<>();
  private final Map<TapKey, StreamTap> taps = new HashMap<>();
  private final Set<String> leftOut = new ConcurrentSkipListSet<>();
  private final Thread thread = Thread.ofPlatform().daemon().name("robotui-recorder").unstarted(this::run);
  private volatile boolean closed;

  /** Begins at once. */
  public Collector(Host host, RecordingChoice choice, WallTime time, Consumer<Captured> sink) {
    this.host = host;
    this.robots = NamePatterns.of(choice.robots());
    this.ports = NamePatterns.of(choice.ports());
    HeadTable heads = new HeadTable();
    this.shared = new StreamTap.Shared(time, heads, new SeenMessages(), sink);
    this.events = new EventWatch(host, robots, time, sink);
    heads.add(events.head());
    this.faults = host.listen(events);
    thread.start();
  }

  /** The series that were met so far. */
  public List<StreamHead> heads() {
    return shared.heads().all();
  }

  /** The streams that were met and are recorded only where a choice names them, and none does. */
  public List<String> leftOut() {
    return List.copyOf(leftOut);
  }

  /** What RobotUI itself has to say. */
  public EventWatch events() {
    return events;
  }

  private void run() {
    long scan = System.nanoTime();
    while (!closed) {
      long now = System.nanoTime();
      if (now - scan >= 0) {
        guarded(this::scan);
        scan = now + SCAN_NANOS;
      }
      guarded(events::look);
      long next = now + LONGEST_PAUSE;
      for (StreamTap tap : taps.values()) {
        if (now - tap.due() >= 0) {
          guarded(() -> tap.drain(now));
        }
        next = Math.min(next, tap.due());
      }
      LockSupport.parkNanos(Math.max(1_000_000L, next - System.nanoTime()));
    }
    guarded(() -> taps.values().forEach(tap -> tap.drain(System.nanoTime())));
    guarded(events::lookNow);
    accesses.values().forEach(PortAccess::close);
  }

  /** One stream that cannot be taken must not end all others. */
  private static void guarded(Runnable part) {
    try {
      part.run();
    } catch (RuntimeException e) {
      LOG.warn("a part of what robots send is not recorded", e);
    }
  }

  private void scan() {
    List<Ruic> there = host.ruics();
    accesses.keySet().removeIf(ruic -> {
      boolean gone = !there.contains(ruic);
      if (gone) {
        accesses.get(ruic).close();
        taps.keySet().removeIf(key -> key.ruic() == ruic);
      }
      return gone;
    });
    there.forEach(this::scan);
  }

  private void scan(Ruic ruic) {
    Map<String, String> robotOf = new HashMap<>();
    for (InterfaceConfig each : ruic.interfaces()) {
      String robot = each.robot().isEmpty() ? ruic.name() : each.robot();
      if (robots.mean(ruic.name(), robot)) {
        robotOf.put(each.id(), robot);
      }
    }
    Map<String, String> frameworks = new HashMap<>();
    RuicSnapshot now = ruic.snapshot();
    now.components().stream().filter(c -> c.kind() == ComponentStatus.Kind.RFIC)
        .forEach(c -> frameworks.put(c.id(), c.type()));
    for (PortStatus port : now.ports()) {
      SourceId id = port.port();
      if (port.kind() == PortKind.STREAM && robotOf.containsKey(id.component())
          && ports.mean(id.toString(), id.port(), "/" + id.port())) {
        meet(new TapKey(ruic, id), robotOf.get(id.component()), frameworks.getOrDefault(id.component(), ""));
      }
    }
  }

  private void meet(TapKey key, String robot, String framework) {
    if (taps.containsKey(key)) {
      return;
    }
    if (ports.patterns().isEmpty() && isOnlyOnRequest(key.ruic(), key.port())) {
      leftOut.add(key.port().toString());
    } else {
      taps.put(key, tap(key, robot, framework));
    }
  }

  private boolean isOnlyOnRequest(Ruic ruic, SourceId id) {
    return access(ruic).port(PortKind.STREAM, id)
        .filter(port -> port instanceof StreamPort<?> stream && stream.intake() == Intake.CHOSEN).isPresent();
  }

  private PortAccess access(Ruic ruic) {
    return accesses.computeIfAbsent(ruic, each -> each.access(WHO));
  }

  private StreamTap tap(TapKey key, String robot, String framework) {
    return new StreamTap(new Place(key.ruic().name(), robot, framework, key.port()), access(key.ruic()), shared);
  }

  /** Takes what is there still; nothing comes to the sink when this has ended. */
  @Override
  public void close() {
    closed = true;
    faults.close();
    LockSupport.unpark(thread);
    if (Thread.currentThread() != thread) {
      Uninterruptibles.await(System.nanoTime() + END.toNanos(), nanos -> thread.join(Duration.ofNanos(nanos)));
    }
  }
}
