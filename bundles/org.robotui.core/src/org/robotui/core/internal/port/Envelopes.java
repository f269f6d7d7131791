package org.robotui.core.internal.port;

import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;
import org.robotui.data.Keyed;

/** Conflation of two envelopes; the first may be absent (null, as atomic references hold it). */
final class Envelopes {
  private Envelopes() {}

  static <T extends Data> Envelope<T> newest(Envelope<T> held, Envelope<T> other) {
    return held == null || other.sequence() > held.sequence() ? other : held;
  }

  static <T extends Data> Envelope<T> merged(Envelope<T> held, Envelope<T> other) {
    if (held == null) {
      return other;
    }
    Envelope<T> newer = newest(held, other);
    Envelope<T> older = newer == held ? other : held;
    T value = over(newer.value(), older.value());
    // The raw bytes of one message are not those of the merged value.
    return new Envelope<>(value, newer.source(), newer.sequence(), newer.stamp(), newer.receivedNanos(), Optional.empty());
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // Keyed values of one class merge with each other by contract
  private static <T extends Data> T over(T newer, T older) {
    boolean mergeable = newer instanceof Keyed && newer.getClass() == older.getClass();
    return mergeable ? (T) ((Keyed) newer).over((Keyed) older) : newer;
  }
}
