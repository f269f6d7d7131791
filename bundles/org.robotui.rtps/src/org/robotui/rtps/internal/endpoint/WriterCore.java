package org.robotui.rtps.internal.endpoint;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.rtps.Durability;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reliability;
import org.robotui.rtps.Sample;
import org.robotui.rtps.SampleIdentity;
import org.robotui.rtps.WriterStatistics;
import org.robotui.rtps.internal.wire.SequenceSet;

/**
 * A writer, built-in or not, with the readers that it is matched with. It sends on the thread that writes, and repairs
 * on that of the timers. Safe for all threads.
 */
public final class WriterCore {

  /** Between two turns a reader that has a processor takes what the turn before brought. */
  private static final long NEXT_TURN = 150_000;

  private final EntityId self;
  private final Qos qos;
  private final Timers timers;
  private final Timers.Timer timer;
  private final EndpointOutlet outlet;
  private final AtomicInteger counts;
  private final ChangeCache cache;
  private final Sending sending;
  private final PacedChanges paced;
  private final Beat beat = new Beat();
  private final WriterTally tally = new WriterTally();
  private final Map<Guid, RemoteReader> readers = new LinkedHashMap<>();
  private List<SendTarget> targets = List.of();
  private long last;
  private boolean closed;

  /** Matched with nobody yet. */
  public WriterCore(Guid self, Qos qos, long mostBytes, Timers timers, EndpointOutlet outlet, AtomicInteger counts) {
    this.self = self.entity();
    this.qos = qos;
    this.timers = timers;
    this.timer = timers.timer(this::run);
    this.outlet = outlet;
    this.counts = counts;
    this.cache = new ChangeCache(qos, mostBytes);
    this.sending = new Sending(self.entity());
    this.paced = new PacedChanges(sending);
  }

  /** Writes a change; empty if there is no room for it. The payload is kept and must not be changed. */
  public synchronized OptionalLong write(Sample.Kind kind, ByteBuffer payload, long sourceNanos,
      Optional<SampleIdentity> related, Optional<Guid> instance) {
    forget();
    if (closed || !cache.admits(payload.remaining())) {
      tally.refused();
      return OptionalLong.empty();
    }
    Change change = new Change(++last, kind, payload, sourceNanos, related, instance);
    tally.written(change);
    if (qos.durability() != Durability.VOLATILE || anyReliable()) {
      cache.add(change).forEach(this::dropped);
    }
    send(change);
    if (anyReliable()) {
      beat.news(timers.now());
      timer.wake(beat.due());
    }
    return OptionalLong.of(last);
  }

  private void send(Change change) {
    if (!paced.applies(change)) {
      targets.forEach(target -> send(target, change));
      return;
    }
    boolean first = paced.isEmpty();
    boolean room = true;
    for (SendTarget target : targets) {
      room = paced.add(target, change);
    }
    if (!room) {
      paced.all(outlet, this::sent);
    } else if (first) {
      paced.turn(outlet, this::sent);
    }
    if (!paced.isEmpty()) {
      timer.wake(timers.now() + NEXT_TURN);
    }
  }

  private void sent(EndpointOutlet.Batch batch, SendTarget target) {
    if (target.reliable()) {
      beat(batch, target.reader(), cache.first(last + 1), false);
    }
  }

  private void dropped(Change change) {
    if (readers.values().stream().anyMatch(each -> each.reliable() && each.acknowledged() <= change.sequence())) {
      tally.unacknowledged();
    }
  }

  private boolean anyReliable() {
    return targets.stream().anyMatch(SendTarget::reliable);
  }

  private void send(SendTarget target, Change change) {
    try (EndpointOutlet.Batch batch = outlet.to(target.destination())) {
      sending.change(batch, target.reader(), target.destination(), change);
      sent(batch, target);
    }
  }

  private void beat(EndpointOutlet.Batch batch, EntityId reader, long first, boolean answer) {
    batch.heartbeat(reader, self, first, last, counts.incrementAndGet(), answer);
  }

  /** Drops what nobody needs any more. */
  private void forget() {
    if (qos.durability() == Durability.VOLATILE) {
      cache.removeBefore(allAcknowledged());
    } else {
      cache.removeEndedBefore(allAcknowledged()); // who comes later never heard of them
    }
    if (!Qos.infinite(qos.lifespan())) {
      cache.removeOlder(SourceClock.nanos() - qos.lifespan().toNanos());
    }
  }

  private long allAcknowledged() {
    long least = last + 1;
    for (RemoteReader reader : readers.values()) {
      least = reader.reliable() ? Math.min(least, reader.acknowledged()) : least;
    }
    return least;
  }

  /** Writes to a reader from now on. */
  public synchronized void match(EndpointInfo reader, Destination destination) {
    boolean reliable =
        qos.reliability() == Reliability.RELIABLE && reader.qos().reliability() == Reliability.RELIABLE;
    boolean history =
        qos.durability() != Durability.VOLATILE && reader.qos().durability() != Durability.VOLATILE && reliable;
    long start = history ? 1 : last + 1;
    RemoteReader remote = new RemoteReader(reader, destination, reliable, start);
    readers.put(reader.guid(), remote);
    aim();
    if (reliable) {
      timer.wake(timers.now());
      beat.news(timers.now());
      greet(remote);
    }
  }

  private void greet(RemoteReader reader) {
    try (EndpointOutlet.Batch batch = outlet.to(reader.destination())) {
      ask(batch, reader);
    }
  }

  private void ask(EndpointOutlet.Batch batch, RemoteReader reader) {
    beat(batch, reader.info().guid().entity(), firstFor(reader), true);
  }

  private long firstFor(RemoteReader reader) {
    return Math.min(Math.max(reader.start(), cache.first(last + 1)), last + 1);
  }

  /** Writes to it no more. */
  public synchronized void unmatch(Guid reader) {
    if (readers.remove(reader) != null) {
      aim();
      notifyAll();
    }
  }

  private void aim() {
    Map<Destination, List<RemoteReader>> byPlace = new LinkedHashMap<>();
    readers.values().forEach(each -> byPlace.computeIfAbsent(each.destination(), none -> new ArrayList<>()).add(each));
    List<SendTarget> aimed = new ArrayList<>();
    byPlace.forEach((place, there) -> aimed.add(new SendTarget(place,
        there.size() == 1 ? there.getFirst().info().guid().entity() : EntityId.UNKNOWN,
        there.stream().anyMatch(RemoteReader::reliable))));
    targets = List.copyOf(aimed);
    paced.keep(targets);
  }

  /** A reader says what it has and lacks, and whether it wants to be told what there is. */
  public synchronized void acknowledged(Guid from, SequenceSet missing, boolean answer) {
    RemoteReader reader = readers.get(from);
    if (reader == null || !reader.reliable() || missing.base() < 0) {
      return;
    }
    long before = reader.acknowledged();
    reader.acknowledged(missing, last);
    if (reader.acknowledged() != before) {
      beat.progress(timers.now());
      forget();
      notifyAll();
    }
    if (answer) {
      greet(reader);
    }
    if (reader.acknowledged() <= last) {
      beat.news(timers.now());
    }
    timer.wake(reader.asks() ? timers.now() : beat.due());
  }

  /** A reader lacks fragments of a change. */
  public synchronized void lacks(Guid from, long sequence, SequenceSet missing) {
    RemoteReader reader = readers.get(from);
    if (reader != null && reader.reliable() && sequence >= reader.start() && sequence <= last) {
      long count = cache.get(sequence).map(change -> Sending.count(change, reader.destination())).orElse(1L);
      reader.lacks(sequence, missing, count);
      timer.wake(timers.now());
    }
  }

  private synchronized long run(long now) {
    if (closed) {
      return Timers.NEVER;
    }
    boolean more = false;
    for (RemoteReader reader : readers.values()) {
      if (reader.asks()) {
        try (EndpointOutlet.Batch batch = outlet.to(reader.destination())) {
          sending.repair(batch, reader, cache);
        }
        more |= reader.asks();
      }
    }
    paced.turn(outlet, this::sent);
    if (!paced.isEmpty()) {
      return now + NEXT_TURN; // who is asked now says that it lacks what is on its way
    }
    if (beat.due() <= now) {
      beat.asked(now, askAll());
    }
    return more ? Math.min(beat.due(), now + NEXT_TURN) : beat.due();
  }

  /** Asks those that do not have all; whether there are such. */
  private boolean askAll() {
    boolean any = false;
    for (RemoteReader reader : readers.values()) {
      if (reader.reliable() && reader.acknowledged() <= last) {
        any = true;
        greet(reader);
      }
    }
    return any;
  }

  /** Says that it is alive, as liveliness by topic demands of whoever has nothing to write. */
  public synchronized void assertAlive() {
    readers.values().stream().filter(RemoteReader::reliable).forEach(reader -> {
      try (EndpointOutlet.Batch batch = outlet.to(reader.destination())) {
        batch.alive(reader.info().guid().entity(), self, firstFor(reader), last, counts.incrementAndGet());
      }
    });
  }

  /** Blocks until all that was written is acknowledged by all, or a time has passed. */
  public synchronized boolean awaitAcknowledged(Duration timeout) throws InterruptedException {
    long written = last;
    long deadline = System.nanoTime() + timeout.toNanos();
    while (allAcknowledged() <= written) {
      long left = deadline - System.nanoTime();
      if (left <= 0) {
        return false;
      }
      wait(left / 1_000_000 + 1);
    }
    return true;
  }

  /** What was counted. */
  public synchronized WriterStatistics statistics() {
    return tally.statistics(sending.repaired(), cache);
  }

  /** Writes no more. */
  public synchronized void close() {
    paced.all(outlet, this::sent);
    closed = true;
    timer.cancel();
    readers.clear();
    targets = List.of();
    notifyAll();
  }
}
