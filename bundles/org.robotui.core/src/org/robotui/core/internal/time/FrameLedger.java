package org.robotui.core.internal.time;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongSupplier;
import org.robotui.api.frame.FrameLink;
import org.robotui.api.frame.FrameRefusal;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.geometry.FrameEdge;
import org.robotui.net.collection.LruMap;

/**
 * Who said where frames are, how often, and what was refused. As many frames as the buffer holds, a few words on each.
 * Safe for all threads.
 */
final class FrameLedger {
  private static final int MOST_REFUSALS = 20;
  private static final double NANO = 1e-9;

  private record Refused(String reason, String authority) {}

  private record Count(long count, long lastNanos) {}

  private final LongSupplier clock;
  private final Map<FrameId, FrameVoices> voices = new ConcurrentHashMap<>();
  private final Map<Refused, Count> refusals = new LruMap<>(MOST_REFUSALS);

  FrameLedger(LongSupplier clock) {
    this.clock = clock;
  }

  /** A transform was taken. */
  void taken(FrameTransform transform, String authority) {
    voices.computeIfAbsent(transform.child(), child -> new FrameVoices())
        .say(transform.parent(), authority, transform.fixed(), transform.stamp().clock(), clock.getAsLong());
  }

  /** A transform was refused. */
  void refused(String reason, String authority) {
    synchronized (refusals) {
      Refused key = new Refused(reason, authority);
      long before = Optional.ofNullable(refusals.get(key)).map(Count::count).orElse(0L);
      refusals.put(key, new Count(before + 1, clock.getAsLong()));
    }
  }

  /** The transforms of a buffer, with what is known here. */
  List<FrameLink> links(List<FrameEdge<FrameId>> edges) {
    long now = clock.getAsLong();
    return edges.stream().map(edge -> link(edge, Optional.ofNullable(voices.get(edge.child())), now)).toList();
  }

  private static FrameLink link(FrameEdge<FrameId> edge, Optional<FrameVoices> said, long now) {
    ClockKind clock = said.map(FrameVoices::clock).orElse(ClockKind.ROBOT);
    return new FrameLink(edge.parent(), edge.child(), edge.isStatic(),
        edge.isStatic() ? Optional.empty() : Optional.of(new Stamp(edge.newestNanos(), clock)),
        (edge.newestNanos() - edge.oldestNanos()) * NANO, edge.samples(), edge.authority(),
        said.map(FrameVoices::lastNanos).orElse(now),
        edge.isStatic() ? 0 : said.map(v -> v.rateHz(now)).orElse(0.0),
        said.map(v -> v.rivals(edge.parent(), edge.authority(), now)).orElse(List.of()));
  }

  /** What was refused, the newest first. */
  List<FrameRefusal> refusals() {
    synchronized (refusals) {
      List<FrameRefusal> all = new ArrayList<>();
      refusals.forEach(
          (key, count) -> all.add(new FrameRefusal(key.reason(), key.authority(), count.count(), count.lastNanos())));
      return all.stream().sorted(Comparator.comparingLong(FrameRefusal::receivedNanos).reversed()).toList();
    }
  }

  /** The clock jumped back: what moves begins anew, and what was refused was refused of another time. */
  void clear() {
    voices.values().removeIf(said -> !said.fixed());
    synchronized (refusals) {
      refusals.clear();
    }
  }
}
