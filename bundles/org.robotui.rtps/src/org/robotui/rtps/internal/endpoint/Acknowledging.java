package org.robotui.rtps.internal.endpoint;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.VendorId;
import org.robotui.rtps.internal.wire.SequenceSet;

/** Says to writers what a reader has of them and lacks. Its reader's lock guards it. */
final class Acknowledging {

  /** Fragments of which nothing was seen may still be on their way for so long after the last one that came. */
  private static final long IDLE = Duration.ofMillis(10).toNanos();
  private static final int MOST_FRAGMENT_SETS = 8;

  private final EntityId reader;
  private final EndpointOutlet outlet;
  private final AtomicInteger counts;

  /** All counts of a participant grow, so that a peer which remembers an earlier reader takes none for an old one. */
  Acknowledging(EntityId reader, EndpointOutlet outlet, AtomicInteger counts) {
    this.reader = reader;
    this.outlet = outlet;
    this.counts = counts;
  }

  void say(RemoteWriter writer, long now) {
    Received received = writer.received();
    EntityId to = writer.info().guid().entity();
    try (EndpointOutlet.Batch batch = outlet.to(writer.destination())) {
      if (!received.begun()) {
        batch.acknowledge(reader, to, SequenceSet.none(first(writer)), counts.incrementAndGet(), true);
      } else {
        batch.acknowledge(reader, to, missing(writer), counts.incrementAndGet(), writer.asking().unanswered());
        fragments(writer, to, batch, now);
      }
    }
    writer.asking().said(now, received.missing(), writer.marker());
  }

  /**
   * The number that a reader begins with which knows of none. By the specification that is the first one there is; Fast
   * DDS answers at once only to the one before it, and else with its next heartbeat, 3 s later.
   */
  private static long first(RemoteWriter writer) {
    return writer.info().guid().prefix().vendor().equals(VendorId.FAST_DDS) ? 0 : 1;
  }

  private static SequenceSet missing(RemoteWriter writer) {
    Received received = writer.received();
    SequenceSet.Builder set = new SequenceSet.Builder(received.next());
    long end = Math.min(received.last() + 1, received.next() + SequenceSet.MOST);
    for (long number = received.next(); number < end; number++) {
      if (!received.has(number) && writer.partly(number).isEmpty()) {
        set.add(number);
      }
    }
    return set.build();
  }

  private void fragments(RemoteWriter writer, EntityId to, EndpointOutlet.Batch batch, long now) {
    int sets = 0;
    for (var entry : writer.assemblies().entrySet()) {
      Assembly assembly = entry.getValue();
      long end = now - assembly.progress() >= IDLE ? assembly.count() : assembly.highest();
      long from = 1;
      for (Optional<SequenceSet> set = missing(assembly, from, end); set.isPresent() && sets < MOST_FRAGMENT_SETS; set =
          missing(assembly, from, end)) {
        batch.missingFragments(reader, to, entry.getKey(), set.get(), counts.incrementAndGet());
        from = set.get().end();
        sets++;
      }
    }
  }

  /** The next set of fragments that lack, if there is one. */
  private static Optional<SequenceSet> missing(Assembly assembly, long from, long end) {
    long base = from > end ? 0 : assembly.missingFrom(from);
    if (base == 0 || base > end) {
      return Optional.empty();
    }
    SequenceSet.Builder set = new SequenceSet.Builder(base);
    for (long number = base; number <= Math.min(end, base + SequenceSet.MOST - 1); number++) {
      if (assembly.missing(number)) {
        set.add(number);
      }
    }
    return Optional.of(set.build());
  }
}
