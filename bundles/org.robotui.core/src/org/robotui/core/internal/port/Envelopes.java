package org.robotui.core.internal.port;

import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** Conflation of two envelopes; the first may be absent (null, as atomic references hold it). */
final class Envelopes {
  private Envelopes() {}

  static <T extends Data> Envelope<T> newest(Envelope<T> held, Envelope<T> other) {
    return held == null || other.sequence() > held.sequence() ? other : held;
  }
}
