package org.robotui.rtps.internal.endpoint;

import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.internal.wire.SequenceSet;

/** A writer that a reader listens to, and what came of it. Its reader's lock guards it. */
final class RemoteWriter {

  private static final int MOST_ASSEMBLIES = 32;

  private final EndpointInfo info;
  private final Destination destination;
  private final boolean reliable;
  private final boolean wantsHistory;
  private final Received received;
  private final MemoryBudget partial;
  private final TreeMap<Long, Assembly> assemblies = new TreeMap<>();
  private final Asking asking;
  private long lastBestEffort;
  private long lost;
  private long incomplete;

  RemoteWriter(EndpointInfo info, Destination destination, boolean reliable, boolean wantsHistory, MemoryBudget waiting,
      MemoryBudget partial, long now) {
    this.info = info;
    this.destination = destination;
    this.reliable = reliable;
    this.wantsHistory = wantsHistory;
    this.received = new Received(waiting);
    this.partial = partial;
    this.asking = new Asking(now);
  }

  EndpointInfo info() {
    return info;
  }

  Destination destination() {
    return destination;
  }

  boolean reliable() {
    return reliable;
  }

  Received received() {
    return received;
  }

  Asking asking() {
    return asking;
  }

  /** Takes a whole change; false if there can be none such. */
  boolean data(Change change, List<Change> inOrder) {
    if (!Received.valid(change.sequence())) {
      return false;
    }
    if (reliable) {
      begin(change.sequence());
      received.take(change, inOrder);
      forgetBefore(received.next());
    } else if (change.sequence() > lastBestEffort) {
      lost += lastBestEffort == 0 ? 0 : change.sequence() - lastBestEffort - 1;
      lastBestEffort = change.sequence();
      inOrder.add(change);
      forgetBefore(lastBestEffort + 1);
    }
    return true;
  }

  /** Who wants no history begins with what comes first. */
  private void begin(long sequence) {
    if (!received.begun()) {
      received.begin(wantsHistory ? 1 : sequence);
    }
  }

  /** Takes fragments; false if they contradict themselves or what came before. */
  boolean fragments(Fragments fragments, int mostBytes, List<Change> inOrder, long now) {
    long sequence = fragments.about().sequence();
    if (!Received.valid(sequence)) {
      return false;
    }
    if (reliable) {
      begin(sequence);
      received.exists(sequence);
    }
    if (reliable ? received.has(sequence) : sequence <= lastBestEffort) {
      return true;
    }
    Optional<Assembly> assembly = assembly(sequence, fragments, mostBytes, now);
    return assembly.isPresent() && add(sequence, assembly.get(), fragments, inOrder, now);
  }

  private boolean add(long sequence, Assembly assembly, Fragments fragments, List<Change> inOrder, long now) {
    long before = assembly.held();
    if (!partial.take(assembly.held(fragments) - before)) {
      return true; // it is asked for again, or lost
    }
    long granted = assembly.held(fragments) - before;
    boolean sane = assembly.add(fragments, now);
    partial.free(granted - (assembly.held() - before));
    if (assembly.complete()) {
      remove(sequence);
      data(assembly.change(), inOrder);
    }
    return sane;
  }

  private Optional<Assembly> assembly(long sequence, Fragments fragments, int mostBytes, long now) {
    Assembly there = assemblies.get(sequence);
    if (there != null) {
      return Optional.of(there);
    }
    Optional<Assembly> fresh = Assembly.begin(fragments, mostBytes, now);
    fresh.ifPresent(assembly -> {
      assemblies.put(sequence, assembly);
      if (assemblies.size() > MOST_ASSEMBLIES) {
        // the newest of a reliable writer will come again, the oldest of another one never
        remove(reliable ? assemblies.lastKey() : assemblies.firstKey());
        incomplete++;
      }
    });
    return fresh.filter(assembly -> assemblies.get(sequence) == assembly);
  }

  private void remove(long sequence) {
    partial.free(assemblies.remove(sequence).held());
  }

  private void forgetBefore(long sequence) {
    while (!assemblies.isEmpty() && assemblies.firstKey() < sequence) {
      incomplete++;
      remove(assemblies.firstKey());
    }
  }

  /** Takes what a reliable writer says it has; false if that cannot be. */
  boolean heartbeat(long first, long last, List<Change> inOrder) {
    if (first < 1 || last < first - 1 || last != 0 && !Received.valid(last)) {
      return false;
    }
    asking.answered();
    if (!received.begun()) {
      received.begin(first); // not behind the last one: it may have been written between the match there and ours
    }
    received.exists(last);
    if (first > received.next()) {
      received.skipTo(first, inOrder);
    }
    forgetBefore(received.next());
    return true;
  }

  /** Takes numbers that never come. */
  boolean gap(long start, SequenceSet set, List<Change> inOrder) {
    if (!Received.valid(start) || !Received.valid(set.end()) || set.base() < start) {
      return false;
    }
    if (!received.begun()) {
      received.begin(wantsHistory ? 1 : start);
    }
    if (set.base() > start) {
      received.irrelevant(start, set.base(), inOrder);
    }
    for (long number = set.base(); number < set.end(); number++) {
      if (set.contains(number)) {
        received.irrelevant(number, number + 1, inOrder);
      }
    }
    forgetBefore(received.next());
    return true;
  }

  /** The sample of which parts came. */
  Optional<Assembly> partly(long sequence) {
    return Optional.ofNullable(assemblies.get(sequence));
  }

  /** Another one when something came that was missing. */
  long marker() {
    return received.next() * 31 + (assemblies.isEmpty() ? 0 : assemblies.firstEntry().getValue().received());
  }

  Map<Long, Assembly> assemblies() {
    return assemblies;
  }

  /** Gives up parts of samples of which nothing more came since then. */
  void expire(long since) {
    for (Iterator<Assembly> each = assemblies.values().iterator(); each.hasNext();) {
      Assembly assembly = each.next();
      if (assembly.progress() < since) {
        partial.free(assembly.held());
        each.remove();
        incomplete++;
      }
    }
  }

  /** Gives up the oldest sample of which parts came. */
  void dropOldestPart() {
    remove(assemblies.firstKey());
    incomplete++;
  }

  /** The memory of what is not complete. */
  long partialBytes() {
    return assemblies.values().stream().mapToLong(Assembly::held).sum();
  }

  /** How many never came since this was asked. */
  long takeLost() {
    long count = lost + received.takeLost();
    lost = 0;
    return count;
  }

  /** How many were given up since this was asked. */
  long takeIncomplete() {
    long count = incomplete;
    incomplete = 0;
    return count;
  }

  /** Gives its memory back. */
  void clear() {
    received.clear();
    assemblies.values().forEach(each -> partial.free(each.held()));
    assemblies.clear();
  }
}
