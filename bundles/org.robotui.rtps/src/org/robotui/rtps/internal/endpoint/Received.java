package org.robotui.rtps.internal.endpoint;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * What came of a reliable writer: everything before {@link #next}, and beyond it changes that wait for those before
 * them, and numbers that never come. Its reader's lock guards it.
 */
final class Received {

  private static final int MOST_HELD = 10_000;
  private static final long MOST_NUMBER = 1L << 62;

  private final MemoryBudget memory;
  private final TreeMap<Long, Held> held = new TreeMap<>();
  private long next;
  private long last;
  private long lost;

  /** The numbers from its key to its end: one change, or numbers that never come. */
  private record Held(long end, List<Change> change) {

    private long bytes() {
      return change.isEmpty() ? 0 : change.getFirst().size();
    }
  }

  Received(MemoryBudget memory) {
    this.memory = memory;
  }

  /** Whether a number can be one. */
  static boolean valid(long number) {
    return number >= 1 && number < MOST_NUMBER;
  }

  /** The first number is known from now on. */
  void begin(long first) {
    next = first;
  }

  boolean begun() {
    return next != 0;
  }

  /** The first number that did not come. */
  long next() {
    return next;
  }

  /** The highest number that is known to exist. */
  long last() {
    return last;
  }

  void exists(long number) {
    last = Math.max(last, number);
  }

  /** Whether something before the highest number did not come. */
  boolean missing() {
    return begun() && next <= last;
  }

  /** Whether a number is not needed any more. */
  boolean has(long number) {
    Map.Entry<Long, Held> entry = held.floorEntry(number);
    return number < next || entry != null && number < entry.getValue().end();
  }

  /** Takes a change; what is in order now is added to the list. */
  void take(Change change, List<Change> inOrder) {
    long number = change.sequence();
    exists(number);
    if (has(number)) {
      return;
    }
    while (number != next && !hold(change)) {
      giveUp(number, inOrder);
      if (has(number)) {
        return;
      }
    }
    if (number == next) {
      inOrder.add(change);
      next++;
      advance(inOrder);
    }
  }

  private boolean hold(Change change) {
    if (held.size() >= MOST_HELD || !memory.take(change.size())) {
      return false;
    }
    held.put(change.sequence(), new Held(change.sequence() + 1, List.of(change)));
    return true;
  }

  /** Without room, those before the first that waits are lost, or all before this one where none waits. */
  private void giveUp(long number, List<Change> inOrder) {
    skipTo(held.isEmpty() ? number : Math.min(number, held.firstKey()), inOrder);
  }

  /** All before a number do not come any more; those that are there are delivered. */
  void skipTo(long number, List<Change> inOrder) {
    while (next < number) {
      Map.Entry<Long, Held> entry = held.firstEntry();
      long until = entry == null ? number : Math.min(number, entry.getKey());
      lost += until - next;
      next = until;
      advance(inOrder);
    }
    advance(inOrder);
  }

  /** Numbers that never come, up to the end. */
  void irrelevant(long from, long end, List<Change> inOrder) {
    if (from <= next) {
      next = Math.max(next, end);
      advance(inOrder);
    } else if (held.size() < MOST_HELD && !has(from)) {
      held.put(from, new Held(end, List.of()));
    }
    exists(end - 1);
  }

  private void advance(List<Change> inOrder) {
    for (Map.Entry<Long, Held> entry = held.firstEntry(); entry != null && entry.getKey() <= next; entry =
        held.firstEntry()) {
      held.pollFirstEntry();
      memory.free(entry.getValue().bytes());
      if (entry.getKey() == next || !entry.getValue().change().isEmpty()) {
        inOrder.addAll(entry.getValue().change());
      }
      next = Math.max(next, entry.getValue().end());
    }
  }

  /** How many never came, since this was asked. */
  long takeLost() {
    long count = lost;
    lost = 0;
    return count;
  }

  /** Gives its memory back. */
  void clear() {
    held.values().forEach(each -> memory.free(each.bytes()));
    held.clear();
  }

  /** For tests: how many wait. */
  List<Long> waiting() {
    return new ArrayList<>(held.keySet());
  }
}
