package org.robotui.rtps.internal.endpoint;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.rtps.Durability;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ParticipantLimits;
import org.robotui.rtps.Liveliness;
import org.robotui.rtps.Qos;
import org.robotui.rtps.ReaderStatistics;
import org.robotui.rtps.Reliability;
import org.robotui.rtps.internal.wire.SequenceSet;

/**
 * A reader, built-in or not, by what it hears of the writers that it is matched with. One thread tells it what came and
 * gets what is complete and in order; others may match, and the timers' thread asks for what is missing.
 */
public final class ReaderCore {

  private static final long PATIENCE = Duration.ofSeconds(2).toNanos();
  private static final long EXPIRING = Duration.ofMillis(500).toNanos();

  private final Qos qos;
  private final ParticipantLimits limits;
  private final Timers timers;
  private final Timers.Timer timer;
  private final Acknowledging acknowledging;
  private final MemoryBudget waiting;
  private final MemoryBudget partial;
  private final Map<Guid, RemoteWriter> writers = new HashMap<>();
  private final Map<Guid, WriterWatch> watches = new HashMap<>();
  private final ReaderTally tally = new ReaderTally();

  /** Matched with nobody yet. */
  public ReaderCore(Guid self, Qos qos, ParticipantLimits limits, Timers timers, EndpointOutlet outlet,
      AtomicInteger counts) {
    this.qos = qos;
    this.limits = limits;
    this.timers = timers;
    this.timer = timers.timer(this::run);
    this.acknowledging = new Acknowledging(self.entity(), outlet, counts);
    this.waiting = new MemoryBudget(limits.cacheBytes());
    this.partial = new MemoryBudget(limits.partialBytes());
  }

  /** Listens to a writer from now on. */
  public synchronized void match(EndpointInfo writer, Destination destination) {
    long now = timers.now();
    boolean reliable =
        qos.reliability() == Reliability.RELIABLE && writer.qos().reliability() == Reliability.RELIABLE;
    boolean history =
        qos.durability() != Durability.VOLATILE && writer.qos().durability() != Durability.VOLATILE;
    writers.put(writer.guid(),
        new RemoteWriter(writer, destination, reliable, history, waiting, partial, now));
    watches.put(writer.guid(), new WriterWatch(writer, qos, now));
    timer.wake(now);
  }

  /** Listens to it no more. */
  public synchronized void unmatch(Guid writer) {
    watches.remove(writer);
    RemoteWriter gone = writers.remove(writer);
    if (gone != null) {
      tally.of(gone);
      gone.clear();
    }
  }

  /** A change came whole. Answers what is to be delivered. */
  public synchronized List<Change> data(Guid from, Change change) {
    List<Change> inOrder = new ArrayList<>(1);
    RemoteWriter writer = writers.get(from);
    if (writer != null) {
      long now = timers.now();
      written(from, now);
      told(writer, writer.data(change, inOrder), inOrder, now);
    }
    return inOrder;
  }

  /** Fragments came. Answers what is to be delivered. */
  public synchronized List<Change> fragments(Guid from, Fragments fragments) {
    List<Change> inOrder = new ArrayList<>(1);
    RemoteWriter writer = writers.get(from);
    if (writer != null) {
      long now = timers.now();
      written(from, now);
      makeRoom();
      told(writer, writer.fragments(fragments, limits.sampleBytes(), inOrder, now), inOrder, now);
      if (!writer.assemblies().isEmpty()) {
        timer.wake(now + EXPIRING);
      }
    }
    return inOrder;
  }

  private void written(Guid from, long now) {
    WriterWatch watch = watches.get(from);
    watch.written(now);
    look(watch);
  }

  private void look(WriterWatch watch) {
    long next = watch.next();
    if (next != Timers.NEVER) {
      timer.wake(next);
    }
  }

  /** Whoever fills the memory with parts of samples loses the oldest of its own. */
  private void makeRoom() {
    if (partial.used() > limits.partialBytes() / 4 * 3) {
      writers.values().stream().filter(each -> each.assemblies().size() > 1)
          .max((one, other) -> Long.compare(one.partialBytes(), other.partialBytes()))
          .ifPresent(RemoteWriter::dropOldestPart);
    }
  }

  /** A writer says what it has. Answers what is to be delivered. */
  public synchronized List<Change> heartbeat(Guid from, long first, long last, boolean answer, boolean alive) {
    List<Change> inOrder = new ArrayList<>(0);
    RemoteWriter writer = writers.get(from);
    if (writer != null && writer.reliable()) {
      long now = timers.now();
      if (alive) {
        watches.get(from).asserted(now);
        look(watches.get(from));
      }
      told(writer, writer.heartbeat(first, last, inOrder), inOrder, now);
      if (answer) {
        writer.asking().wanted(now, writer.received().missing());
        ask(writer, now);
      }
    }
    return inOrder;
  }

  /** A writer says what never comes. Answers what is to be delivered. */
  public synchronized List<Change> gap(Guid from, long start, SequenceSet set) {
    List<Change> inOrder = new ArrayList<>(0);
    RemoteWriter writer = writers.get(from);
    if (writer != null && writer.reliable()) {
      told(writer, writer.gap(start, set, inOrder), inOrder, timers.now());
    }
    return inOrder;
  }

  private void told(RemoteWriter writer, boolean sane, List<Change> inOrder, long now) {
    if (!sane) {
      tally.damaged();
    }
    tally.of(writer);
    inOrder.forEach(tally::received);
    if (writer.reliable() && writer.received().missing()) {
      writer.asking().missing(now, writer.marker());
      timer.wake(writer.asking().due());
    } else if (writer.reliable()) {
      writer.asking().came(now, writer.marker());
    }
  }

  /** A participant says that it is alive. */
  public synchronized void alive(GuidPrefix participant, Liveliness kind) {
    long now = timers.now();
    watches.forEach((guid, watch) -> {
      if (guid.prefix().equals(participant)) {
        watch.asserted(kind, now);
        look(watch);
      }
    });
  }

  private void ask(RemoteWriter writer, long now) {
    if (writer.asking().due() <= now) {
      acknowledging.say(writer, now);
    }
    timer.wake(writer.asking().due());
  }

  private synchronized long run(long now) {
    long next = Timers.NEVER;
    for (RemoteWriter writer : writers.values()) {
      if (writer.reliable()) {
        ask(writer, now);
        next = Math.min(next, writer.asking().due());
      }
      if (!writer.reliable() && !writer.assemblies().isEmpty()) {
        writer.expire(now - PATIENCE);
        tally.of(writer);
        next = Math.min(next, now + EXPIRING);
      }
    }
    for (WriterWatch watch : watches.values()) {
      look(watch, now);
      next = Math.min(next, watch.next());
    }
    return next;
  }

  private void look(WriterWatch watch, long now) {
    if (watch.missed(now)) {
      tally.late();
    }
    if (watch.died(now)) {
      tally.died();
    }
  }

  /** What was counted. */
  public synchronized ReaderStatistics statistics(long listenerErrors) {
    return tally.statistics(listenerErrors);
  }

  /** Listens to nobody any more. */
  public synchronized void close() {
    timer.cancel();
    writers.values().forEach(RemoteWriter::clear);
    writers.clear();
    watches.clear();
  }
}
