package org.robotui.sim.internal.roblets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.net.socket.HostPort;
import org.robotui.roblets.body.BodyEntry;
import org.robotui.roblets.brain.Brain;
import org.robotui.roblets.brain.BrainOptions;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletOptions;
import org.robotui.roblets.roblet.RobletRunner;
import org.robotui.roblets.watch.BodyWatchListener;
import org.robotui.roblets.watch.BodyWatcher;
import org.robotui.roblets.wire.RobletStatus;
import org.robotui.testkit.rfic.DatagramGate;

/**
 * Each party of the boat goes without a word, as a process that is killed does, and comes back: every roblet, the
 * brain, and whoever watches. No other party is started again, heard late or twice, or loses anything because of it.
 */
@Timeout(240)
class BoatPartiesTest {
  private static final ThreadFactory THREADS = Thread.ofPlatform().daemon().factory();
  private static final Path COUNTERS = Path.of("/proc/self/net/snmp");
  private static final long PATIENCE = TimeUnit.SECONDS.toNanos(90);

  private final Boat boat = new Boat(1);
  private final List<Party> parties = new ArrayList<>();
  private final Thread time = THREADS.newThread(this::sail);
  private final long droppedBefore = droppedBySystem();
  private Brain brain = brain(0);

  BoatPartiesTest() throws IOException {
    for (Supplier<Roblet> maker : BoatDemo.roblets(boat)) {
      parties.add(new Party(maker));
    }
    time.start();
  }

  /** A roblet that speaks with the brain through a gate of its own. */
  private final class Party implements AutoCloseable {
    private final Supplier<Roblet> maker;
    private DatagramGate gate;
    private RobletRunner runner;
    private int runs;

    Party(Supplier<Roblet> maker) throws IOException {
      this.maker = maker;
      start();
    }

    private void start() throws IOException {
      gate = new DatagramGate();
      gate.open(at());
      runner = new RobletRunner(maker, RobletOptions.of(THREADS, new HostPort("127.0.0.1", gate.port())));
      runs++;
    }

    void killAndStart() throws IOException {
      gate.hold(); // so that its last word goes nowhere
      close();
      start();
    }

    String name() {
      return runner.form().name();
    }

    @Override
    public void close() {
      runner.close();
      gate.close();
    }
  }

  /** Counts what it hears, through a gate. */
  private final class Watching implements AutoCloseable {
    final AtomicLong heard = new AtomicLong();
    final DatagramGate gate = new DatagramGate();
    private final BodyWatcher watcher;

    Watching(String name) throws IOException {
      gate.open(at());
      InetSocketAddress there = new InetSocketAddress(InetAddress.getLoopbackAddress(), gate.port());
      watcher = new BodyWatcher(name, there, THREADS, new BodyWatchListener() {
        @Override
        public void said(String roblet, BodyEntry entry, byte[] bytes) {
          heard.incrementAndGet();
        }
      });
      watcher.want(Set.of(BodyWatcher.ALL));
    }

    @Override
    public void close() {
      watcher.close();
      gate.close();
    }
  }

  /** Datagrams for which the buffer of a socket had no place, of any process. */
  private static long droppedBySystem() throws IOException {
    List<String[]> udp = Files.readAllLines(COUNTERS).stream().filter(row -> row.startsWith("Udp: "))
        .map(row -> row.split(" ")).toList();
    return Long.parseLong(udp.getLast()[List.of(udp.getFirst()).indexOf("RcvbufErrors")]);
  }

  private static Brain brain(int port) throws IOException {
    Brain brain = new Brain(BrainOptions.loopback(THREADS, port, "boat"));
    brain.rule(BoatPilot.rule());
    return brain;
  }

  private InetSocketAddress at() {
    return new InetSocketAddress(InetAddress.getLoopbackAddress(), brain.port());
  }

  private void sail() {
    while (!Thread.currentThread().isInterrupted()) {
      boat.step(0.02);
      LockSupport.parkNanos(20_000_000);
    }
  }

  @AfterEach
  void end() {
    time.interrupt();
    parties.forEach(Party::close);
    brain.close();
  }

  private void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - end < 0, () -> what + ": " + brain.roblets());
      LockSupport.parkNanos(10_000_000);
    }
  }

  private boolean run(Party party) {
    return brain.roblets().stream().anyMatch(s -> s.form().name().equals(party.name())
        && s.state().equals(RobletStatus.RUNNING) && s.tally().runs() == party.runs);
  }

  private boolean areAllHeard() {
    return parties.stream().allMatch(this::run) && brain.bodymap().snapshot().parts().size() == parties.size();
  }

  @Test
  void eachRobletIsKilledAndComesBack() throws IOException {
    await("all are heard", this::areAllHeard);
    for (Party party : parties) {
      party.killAndStart();
      await(party.name() + " is another run", () -> run(party));
    }
    await("the boat is under way", () -> boat.throttle() > 0.5);
    assertNobodyWasDisturbed(2);
  }

  @Test
  void theBrainIsKilledAndComesBack() throws IOException {
    await("the boat is under way", () -> areAllHeard() && boat.throttle() > 0.5);
    int port = brain.port();
    brain.close();
    await("the motor goes out by itself", () -> boat.throttle() == 0);
    brain = brain(port);
    await("it knows all, and the boat is under way", () -> areAllHeard() && boat.throttle() > 0.5);
    parties.forEach(party -> assertEquals(0, party.runner.restarts(), party::name));
  }

  @Test
  void whoWatchesIsKilledAndComesBack() throws IOException {
    try (Watching killed = new Watching("killed"); Watching other = new Watching("other")) {
      await("both hear", () -> areAllHeard() && killed.heard.get() > 50 && other.heard.get() > 50);
      killed.gate.hold();
      await("it is forgotten", () -> brain.watchers().equals(Set.of("other")));
      long before = other.heard.get();
      await("the other one hears on", () -> other.heard.get() > before + 50);
      killed.gate.goOn();
      long silent = killed.heard.get();
      await("it hears again", () -> killed.heard.get() > silent + 50);
    }
    await("nobody watches", () -> brain.watchers().isEmpty());
    assertNobodyWasDisturbed(1);
  }

  /** What the system drops where a machine gives the brain no time for many seconds is lost by no party's fault. */
  private void assertNobodyWasDisturbed(int runs) throws IOException {
    long lost = brain.roblets().stream().mapToLong(status -> status.tally().lost()).sum();
    long dropped = droppedBySystem() - droppedBefore;
    assertTrue(lost <= dropped, () -> lost + " lost, but " + dropped + " dropped by the system: " + brain.roblets());
    for (RobletStatus status : brain.roblets()) {
      assertEquals(runs, status.tally().runs(), status::toString);
      assertEquals(0, status.restarts() + status.tally().late() + status.tally().doubled(), status::toString);
    }
  }
}
