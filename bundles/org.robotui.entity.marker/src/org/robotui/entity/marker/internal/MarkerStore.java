package org.robotui.entity.marker.internal;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.LongToDoubleFunction;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.MarkerSet;

/** The markers that there are, from all sources. Holds {@link #MOST} at most. */
final class MarkerStore {
  static final int MOST = 100_000;

  private final Map<Held.Id, Held> markers = new LinkedHashMap<>();
  private final Chunks chunks = new Chunks();
  private Optional<FrameId> fixed = Optional.empty();
  private Map<String, Integer> counts = Map.of();
  private String flaws = "";
  private boolean changed;
  private long dropped;

  Collection<Held> markers() {
    return markers.values();
  }

  Chunks chunks() {
    return chunks;
  }

  long dropped() {
    return dropped;
  }

  void clear() {
    markers.clear();
    chunks.clear();
    changed = true;
  }

  /** Takes what a source said. */
  void take(SourceId source, MarkerSet set) {
    if (set.all()) {
      markers.values().stream().filter(h -> h.id().source().equals(source)).toList().forEach(this::remove);
    }
    for (MarkerSet.Entry entry : set.entries()) {
      Held.Id id = new Held.Id(source, entry.key());
      entry.marker().ifPresentOrElse(marker -> put(id, marker),
          () -> Optional.ofNullable(markers.get(id)).ifPresent(this::remove));
    }
  }

  private void put(Held.Id id, Marker marker) {
    Held before = markers.get(id);
    if (before != null && before.looksLike(marker) && before.marker().frame().equals(marker.frame())
        && before.marker().locked() == marker.locked()) {
      before.renew(marker);
      before.at(Optional.empty()); // where it is shown is looked up again; where that is the same, nothing is made anew
      return;
    }
    if (before == null && markers.size() >= MOST) {
      dropped++;
      return;
    }
    if (before != null) {
      chunks.remove(before);
    }
    markers.put(id, new Held(id, marker));
    changed = true;
  }

  private void remove(Held held) {
    chunks.remove(held);
    markers.remove(held.id());
    changed = true;
  }

  /** Takes away those whose time is over, and finds the places of new ones. */
  void tick(Spots spots, FrameId fixedFrame, LongToDoubleFunction ages) {
    markers.values().stream().filter(h -> h.over(ages)).toList().forEach(this::remove);
    boolean elsewhere = fixed.filter(fixedFrame::equals).isEmpty();
    fixed = Optional.of(fixedFrame);
    for (Held held : markers.values()) {
      if (elsewhere || held.spot().isEmpty()) {
        place(held, spots.of(held.marker()));
      }
    }
  }

  private void place(Held held, Optional<Spot> spot) {
    held.at(spot);
    boolean same = !held.chunks().isEmpty() && spot.filter(held.chunks().getFirst().group().spot()::equals).isPresent();
    if (!same) {
      chunks.remove(held);
      spot.ifPresent(s -> chunks.add(held, s));
    }
  }

  /** How many markers each namespace has. */
  Map<String, Integer> counts() {
    count();
    return counts;
  }

  /** What is wrong with markers: the first is named, the others are counted; empty where all are well. */
  String flaws() {
    count();
    return flaws;
  }

  private void count() {
    if (changed) {
      Map<String, Integer> found = new TreeMap<>();
      markers.values().forEach(h -> found.merge(h.id().key().namespace(), 1, Integer::sum));
      counts = found;
      long flawed = markers.values().stream().filter(h -> !h.look().flaw().isEmpty()).count();
      flaws = markers.values().stream().filter(h -> !h.look().flaw().isEmpty()).findFirst()
          .map(h -> "marker " + h.id().key() + ": " + h.look().flaw()
              + (flawed > 1 ? "; " + (flawed - 1) + " more with flaws" : ""))
          .orElse("");
      changed = false;
    }
  }
}
