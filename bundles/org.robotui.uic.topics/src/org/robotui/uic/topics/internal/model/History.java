package org.robotui.uic.topics.internal.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** The newest messages of one topic, bounded in count and bytes. While it is held, it stays as it is. One thread. */
final class History {
  static final long MOST_BYTES = 32L << 20;

  private final Deque<Heard> kept = new ArrayDeque<>();
  private long bytes;
  private long count;
  private long missed;

  void take(Envelope<? extends Data> envelope, int capacity, boolean held) {
    count++;
    if (held) {
      missed++;
      return;
    }
    missed = 0;
    Heard heard = new Heard(count, envelope);
    kept.addFirst(heard);
    bytes += heard.size().orElse(0);
    while (kept.size() > capacity || bytes > MOST_BYTES && kept.size() > 1) {
      bytes -= kept.removeLast().size().orElse(0);
    }
  }

  void clear() {
    kept.clear();
    bytes = 0;
    count = 0;
    missed = 0;
  }

  Optional<Heard> newest() {
    return Optional.ofNullable(kept.peekFirst());
  }

  Optional<Heard> find(long number) {
    return kept.stream().filter(heard -> heard.number() == number).findFirst();
  }

  /** The newest first. */
  List<Heard> all() {
    return List.copyOf(kept);
  }

  long count() {
    return count;
  }

  /** How many came since it is held. */
  long missed() {
    return missed;
  }
}
