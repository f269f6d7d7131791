package org.robotui.uic.topics.internal.model;

import java.util.OptionalInt;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.RawMessage;
import org.robotui.data.Data;

/**
 * A message of the echoed topic.
 *
 * @param number counts the messages since the echo began, from 1
 * @param envelope the message
 */
public record Heard(long number, Envelope<? extends Data> envelope) {
  /** How many bytes it had on its way, where that is known. */
  public OptionalInt size() {
    return size(envelope);
  }

  static OptionalInt size(Envelope<?> envelope) {
    return envelope.raw().map(RawMessage::bytes).map(bytes -> OptionalInt.of(bytes.size()))
        .orElseGet(OptionalInt::empty);
  }
}
