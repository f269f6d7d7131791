package org.robotui.core.internal.port;

import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;
import org.robotui.data.Keyed;

/**
 * Values of one source merged by key, and how many keys were given up because there were too many. What is no keyed
 * value is replaced by the newer one.
 */
record Merged<T extends Data>(Envelope<T> envelope, long dropped) {
  /** The first, or merged with what is held; the held one may be absent (null, as atomic references hold it). */
  static <T extends Data> Merged<T> of(Merged<T> held, Envelope<T> other) {
    return held == null ? new Merged<>(other, 0) : held.with(other);
  }

  private Merged<T> with(Envelope<T> other) {
    Envelope<T> newer = Envelopes.newest(envelope, other);
    Envelope<T> older = newer == envelope ? other : envelope;
    boolean mergeable = newer.value() instanceof Keyed && newer.value().getClass() == older.value().getClass();
    return mergeable ? merged(newer, (Keyed<?>) newer.value(), (Keyed<?>) older.value()) : new Merged<>(newer, dropped);
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // Keyed values of one class merge with each other by contract
  private Merged<T> merged(Envelope<T> newer, Keyed value, Keyed before) {
    Keyed all = (Keyed) value.over(before);
    if (all.keys() <= value.most()) {
      return new Merged<>(of(newer, (T) all), dropped);
    }
    int room = value.most() * 3 / 4; // much is given up at once, so that not each of many new keys costs a copy of all
    Keyed kept = (Keyed) value.over(before.last(Math.max(0, room - value.keys())));
    return new Merged<>(of(newer, (T) kept), dropped + all.keys() - kept.keys());
  }

  /** The raw bytes of one message are not those of the merged value. */
  private static <T extends Data> Envelope<T> of(Envelope<T> newer, T value) {
    return new Envelope<>(value, newer.source(), newer.sequence(), newer.stamp(), newer.receivedNanos(),
        Optional.empty());
  }
}
