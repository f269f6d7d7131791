package org.robotui.rfic.recording.internal.session;

import java.util.Optional;
import java.util.function.LongSupplier;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.data.Data;
import org.robotui.data.Stamp;

/**
 * A stream whose values are said to be received just now: that is when the message was received that is being
 * delivered.
 *
 * @param stream takes the values
 * @param received when that was
 * @param <T> the type of the data
 */
record TimedStream<T extends Data>(Publication<T> stream, LongSupplier received) implements Publication<T> {
  @Override
  public void publish(T value, Optional<Stamp> stamp) {
    stream.publish(value, stamp, received.getAsLong(), Optional.empty());
  }

  @Override
  public void publish(T value, Optional<Stamp> stamp, long receivedNanos, Optional<RawMessage> raw) {
    stream.publish(value, stamp, receivedNanos, raw);
  }

  @Override
  public void lost(long count, String reason) {
    stream.lost(count, reason);
  }

  @Override
  public void kept(boolean forLateComers) {
    stream.kept(forLateComers);
  }

  @Override
  public void forget() {
    stream.forget();
  }

  @Override
  public void delivery(String promise) {
    stream.delivery(promise);
  }

  @Override
  public void failed(String reason) {
    stream.failed(reason);
  }

  @Override
  public void close() {
    stream.close();
  }
}
