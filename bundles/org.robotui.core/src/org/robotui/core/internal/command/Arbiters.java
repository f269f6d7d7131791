package org.robotui.core.internal.command;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.locks.LockSupport;
import org.robotui.api.command.Principal;
import org.robotui.core.internal.fence.Thrown;
import org.robotui.core.internal.time.NanoClock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The arbiters of all robots. The same robot in two RUICs has one arbiter; it is remembered when no RUIC has the robot
 * any more, so that a stop stays latched over a restart. Its thread lives only while a RUIC has the robot.
 */
public final class Arbiters implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Arbiters.class);
  private static final long RETRY_NANOS = 10_000_000L;

  private static final class Entry {
    private final Arbiter arbiter;
    private volatile Optional<Thread> thread = Optional.empty();

    Entry(String robot, NanoClock clock, DisplayWatch display, StopListener stops) {
      arbiter = new Arbiter(robot, clock, display, () -> thread.ifPresent(LockSupport::unpark), stops);
    }
  }

  private final NanoClock clock;
  private final DisplayWatch display;
  private final StopListener stops;
  private final Map<String, Entry> entries = new TreeMap<>();

  /** No robots. */
  public Arbiters(NanoClock clock, DisplayWatch display) {
    this(clock, display, StopListener.NONE);
  }

  /** No robots; somebody hears of their stops. */
  public Arbiters(NanoClock clock, DisplayWatch display, StopListener stops) {
    this.stops = stops;
    this.clock = clock;
    this.display = display;
  }

  /** The arbiter of a robot. */
  public synchronized Arbiter of(String robot) {
    return entries.computeIfAbsent(robot, name -> new Entry(name, clock, display, stops)).arbiter;
  }

  /** A RUIC has interfaces to a robot. */
  public synchronized void register(String robot, RobotPorts ports) {
    Arbiter arbiter = of(robot);
    Entry entry = entries.get(robot);
    arbiter.register(ports);
    if (entry.thread.isEmpty()) {
      start(entry);
    }
  }

  private void start(Entry entry) {
    Thread thread = Thread.ofPlatform().daemon().name("arbiter-" + entry.arbiter.robot()).unstarted(() -> run(entry));
    thread.setPriority(Thread.MAX_PRIORITY);
    entry.thread = Optional.of(thread);
    thread.start();
  }

  private void run(Entry entry) {
    Thread me = Thread.currentThread();
    while (entry.thread.filter(t -> t == me).isPresent()) {
      long next = step(entry.arbiter);
      LockSupport.parkNanos(this, Math.max(0, next - clock.nanos()));
    }
  }

  /** One that failed, for want of memory, is tried again soon: nobody else stops the robot. */
  private long step(Arbiter arbiter) {
    try {
      return arbiter.step();
    } catch (RuntimeException | Error e) {
      Thrown.log(LOG, "Deciding about " + arbiter.robot() + " failed", e);
      return clock.nanos() + RETRY_NANOS;
    }
  }

  /** They have ended. */
  public void unregister(String robot, RobotPorts ports) {
    Optional<Thread> ended = remove(robot, ports);
    ended.ifPresent(LockSupport::unpark);
  }

  private synchronized Optional<Thread> remove(String robot, RobotPorts ports) {
    Entry entry = entries.get(robot);
    entry.arbiter.unregister(ports);
    Optional<Thread> ended = entry.arbiter.isUsed() ? Optional.empty() : entry.thread;
    entry.thread = entry.arbiter.isUsed() ? entry.thread : Optional.empty();
    return ended;
  }

  /** Stops all robots that a RUIC has. Returns a sentence for each. */
  public List<String> stopAll(Principal by) {
    return used().stream().map(a -> a.stopAndTell(by)).toList();
  }

  /** Has all look again, since the focus has changed. */
  public void recheckAll() {
    used().forEach(Arbiter::recheck);
  }

  private synchronized Collection<Arbiter> used() {
    return List.copyOf(entries.values().stream().map(e -> e.arbiter).filter(Arbiter::isUsed).toList());
  }

  @Override
  public synchronized void close() {
    for (Entry entry : entries.values()) {
      Optional<Thread> thread = entry.thread;
      entry.thread = Optional.empty();
      thread.ifPresent(LockSupport::unpark);
    }
  }
}
