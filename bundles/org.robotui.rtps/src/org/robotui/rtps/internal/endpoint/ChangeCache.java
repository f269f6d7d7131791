package org.robotui.rtps.internal.endpoint;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.robotui.rtps.Guid;
import org.robotui.rtps.History;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Sample;

/** The changes that a writer keeps, so many of the last of each instance, or all. Its writer's lock guards it. */
final class ChangeCache {

  private static final int MOST_SAMPLES = 10_000;

  private final boolean keepsAll;
  private final int depth;
  private final long mostBytes;
  private final TreeMap<Long, Change> changes = new TreeMap<>();
  private final Map<Guid, TreeMap<Long, Change>> instances = new HashMap<>();
  private final TreeSet<Long> ended = new TreeSet<>();
  private long bytes;

  ChangeCache(Qos qos, long mostBytes) {
    this.keepsAll = qos.history() == History.KEEP_ALL;
    this.depth = keepsAll ? MOST_SAMPLES : qos.depth();
    this.mostBytes = mostBytes;
  }

  /** Whether a change of this size is kept without another one going that must not. */
  boolean admits(int size) {
    return !keepsAll || changes.size() < depth && bytes + size <= mostBytes;
  }

  /** Keeps a change and says which ones had to go for it. */
  List<Change> add(Change change) {
    changes.put(change.sequence(), change);
    if (change.kind() != Sample.Kind.ALIVE) {
      ended.add(change.sequence());
    }
    bytes += change.size();
    List<Change> gone = new ArrayList<>(1);
    Optional<Change> oldest = change.instance().map(key -> ofInstance(key, change)).orElseGet(() -> tooMany(changes));
    oldest.ifPresent(each -> drop(each, gone));
    while (bytes > mostBytes && changes.size() > 1) {
      drop(changes.firstEntry().getValue(), gone);
    }
    return gone;
  }

  private Optional<Change> ofInstance(Guid key, Change change) {
    TreeMap<Long, Change> instance = instances.computeIfAbsent(key, none -> new TreeMap<>());
    instance.put(change.sequence(), change);
    return tooMany(instance);
  }

  private Optional<Change> tooMany(TreeMap<Long, Change> of) {
    return of.size() > depth ? Optional.of(of.firstEntry().getValue()) : Optional.empty();
  }

  private void drop(Change change, List<Change> gone) {
    remove(change.sequence());
    gone.add(change);
  }

  private void remove(long sequence) {
    Change change = changes.remove(sequence);
    ended.remove(sequence);
    bytes -= change.size();
    change.instance().ifPresent(key -> instances.computeIfPresent(key, (same, instance) -> {
      instance.remove(sequence);
      return instance.isEmpty() ? null : instance;
    }));
  }

  /** Drops all before a number. */
  void removeBefore(long sequence) {
    while (!changes.isEmpty() && changes.firstKey() < sequence) {
      remove(changes.firstKey());
    }
  }

  /** Drops what says of instances that they ended, before a number. */
  void removeEndedBefore(long sequence) {
    while (!ended.isEmpty() && ended.first() < sequence) {
      remove(ended.first());
    }
  }

  /** Drops what was written before a time, in nanoseconds since 1970. */
  void removeOlder(long sourceNanos) {
    while (!changes.isEmpty() && changes.firstEntry().getValue().sourceNanos() < sourceNanos) {
      remove(changes.firstKey());
    }
  }

  Optional<Change> get(long sequence) {
    return Optional.ofNullable(changes.get(sequence));
  }

  /** Those from a number on, in their order. */
  Collection<Change> from(long sequence) {
    return changes.tailMap(sequence, true).values();
  }

  /** The first number that is kept, or what is given where there is none. */
  long first(long none) {
    return changes.isEmpty() ? none : changes.firstKey();
  }

  int size() {
    return changes.size();
  }

  long bytes() {
    return bytes;
  }
}
