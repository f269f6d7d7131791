package org.robotui.uic.diagnostics.internal.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Optional;

/** A part of a robot that reports: what it says now and what it said. One thread. */
final class Part {
  private final String name;
  private final Deque<Moment> moments = new ArrayDeque<>();
  private boolean fadedOut;
  private long receivedNanos;

  Part(String name) {
    this.name = name;
  }

  String name() {
    return name;
  }

  /** What it said last. */
  Optional<Moment> newest() {
    return Optional.ofNullable(moments.peekLast());
  }

  long receivedNanos() {
    return receivedNanos;
  }

  void received(long nanos) {
    receivedNanos = nanos;
  }

  /** Adds what it says now, and tells how many bytes of old moments that set free. */
  long add(Moment moment) {
    long freed = 0;
    if (fadedOut && !moments.isEmpty()) {
      freed = moments.removeFirst().bytes();
      fadedOut = false;
    }
    moments.add(moment);
    return freed;
  }

  /** Puts what it says now in place of what it said last. */
  long replaceLast(Moment moment) {
    long freed = moments.removeLast().bytes();
    moments.add(moment);
    return freed;
  }

  /** Forgets its oldest moment; the last one stays until there is another. Tells the bytes set free. */
  long forgetOldest() {
    if (moments.size() > 1) {
      return moments.removeFirst().bytes();
    }
    fadedOut = true;
    return 0;
  }

  /** Forgets what it said last, and tells the bytes set free. */
  long drop() {
    return moments.removeLast().bytes();
  }

  /** The worst of what it said within a time, else what it had said last before. */
  Optional<Moment> at(long from, long to) {
    Optional<Moment> found = Optional.empty();
    for (Iterator<Moment> i = moments.iterator(); i.hasNext();) {
      Moment moment = i.next();
      if (moment.nanos() > to) {
        return found;
      }
      boolean worse = found.filter(f -> f.nanos() >= from && f.level().compareTo(moment.level()) > 0).isEmpty();
      if (worse) {
        found = Optional.of(moment);
      }
    }
    return found;
  }

  /** How it is now: what it said, or stale where that is too long ago. */
  Level level(long now, long staleNanos) {
    return silent(now, staleNanos) ? Level.STALE : newest().map(Moment::level).orElse(Level.UNKNOWN);
  }

  /** Whether it has said nothing for too long. */
  boolean silent(long now, long staleNanos) {
    return now - receivedNanos > staleNanos;
  }
}
