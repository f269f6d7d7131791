package org.robotui.uic.diagnostics.internal.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.robotui.data.status.Diagnostics;

/** Keeps what parts said, within a bound for all together: the oldest goes first. One thread. */
final class History {
  private static final long APART_NANOS = 250_000_000L;

  private final Deque<Part> order = new ArrayDeque<>();
  private final long most;
  private long bytes;

  /** With the bytes that all moments may take together. */
  History(long most) {
    this.most = most;
  }

  /** Notes what a part says. What comes faster than four times a second is noted only where the level changes. */
  void note(Part part, Diagnostics.Item item, long nanos) {
    part.received(nanos);
    Optional<Moment> before = part.newest();
    Moment moment = Moment.of(item, nanos, before);
    if (before.isEmpty() || before.get().level() != moment.level()) {
      add(part, moment);
    } else if (moment.differs(before.get())) {
      change(part, moment, before.get());
    }
    shrink();
  }

  long bytes() {
    return bytes;
  }

  private void change(Part part, Moment moment, Moment before) {
    if (moment.nanos() - before.nanos() < APART_NANOS) {
      Moment kept = new Moment(before.nanos(), moment.level(), moment.hardware(), moment.message(), moment.keys(),
          moment.values(),
          moment.bytes());
      bytes += moment.bytes() - part.replaceLast(kept);
    } else {
      add(part, moment);
    }
  }

  private void add(Part part, Moment moment) {
    bytes += moment.bytes() - part.add(moment);
    order.add(part);
  }

  private void shrink() {
    while (bytes > most && !order.isEmpty()) {
      bytes -= order.removeFirst().forgetOldest();
    }
  }

  /** Forgets a part wholly. */
  void forget(Part part) {
    while (part.newest().isPresent()) {
      bytes -= part.drop();
    }
    order.removeIf(p -> p == part);
  }
}
