package org.robotui.rtps.internal.endpoint;

import java.util.BitSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.internal.wire.SequenceSet;

/**
 * A reader that a writer writes to, what it has acknowledged and what it asked for again. Its writer's lock guards it.
 */
final class RemoteReader {

  private static final int MOST_REQUESTS = 2048;
  private static final int MOST_PARTLY = 32;

  private final EndpointInfo info;
  private final Destination destination;
  private final boolean reliable;
  private final long start;
  private final TreeSet<Long> requested = new TreeSet<>();
  private final TreeMap<Long, BitSet> fragments = new TreeMap<>();
  private long acknowledged;

  /** It gets what is written from a number on. */
  RemoteReader(EndpointInfo info, Destination destination, boolean reliable, long start) {
    this.info = info;
    this.destination = destination;
    this.reliable = reliable;
    this.start = start;
    this.acknowledged = start;
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

  /** The first number that concerns it. */
  long start() {
    return start;
  }

  /** The first number that it has not acknowledged. */
  long acknowledged() {
    return acknowledged;
  }

  /** It has all before the base of the set and lacks what is in the set, of numbers up to the last. */
  void acknowledged(SequenceSet missing, long last) {
    long before = acknowledged;
    // a lower one comes of a reader that lost its memory of us and begins again
    acknowledged = Math.max(start, Math.min(missing.base(), last + 1));
    if (acknowledged > before) {
      requested.headSet(acknowledged).clear();
      fragments.headMap(acknowledged).clear();
    }
    for (long number = missing.base(); number < Math.min(missing.end(), last + 1); number++) {
      if (missing.contains(number) && requested.size() < MOST_REQUESTS) {
        requested.add(number);
      }
    }
  }

  /** It lacks fragments of a change of so many. */
  void lacks(long sequence, SequenceSet missing, long count) {
    if (fragments.size() >= MOST_PARTLY && !fragments.containsKey(sequence)) {
      return;
    }
    BitSet set = fragments.computeIfAbsent(sequence, none -> new BitSet());
    for (long number = missing.base(); number < Math.min(missing.end(), count + 1); number++) {
      if (missing.contains(number)) {
        set.set((int) number);
      }
    }
  }

  boolean asks() {
    return !requested.isEmpty() || !fragments.isEmpty();
  }

  TreeSet<Long> requested() {
    return requested;
  }

  TreeMap<Long, BitSet> fragments() {
    return fragments;
  }
}
