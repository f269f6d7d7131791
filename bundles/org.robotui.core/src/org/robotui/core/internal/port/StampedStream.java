package org.robotui.core.internal.port;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.replay.StreamHistory;
import org.robotui.core.internal.time.StampWatch;
import org.robotui.data.Data;
import org.robotui.data.Stamp;

/** What a robot interface is given of a stream whose stamps tell the time of the robot. */
public record StampedStream<T extends Data>(StreamSource<T> source, StampWatch watch) implements Publication<T> {
  /** The time is noticed first: what comes with the jump itself belongs to the time after it. */
  @Override
  public void publish(T value, Optional<Stamp> stamp, long receivedNanos, Optional<RawMessage> raw) {
    stamp.ifPresent(s -> watch.heard(source.id(), s));
    source.publish(value, stamp, receivedNanos, raw);
  }

  @Override
  public void lost(long count, String reason) {
    source.lost(count, reason);
  }

  @Override
  public void forget() {
    source.forget();
  }

  @Override
  public void kept(boolean forLateComers) {
    source.kept(forLateComers);
  }

  @Override
  public void delivery(String promise) {
    source.delivery(promise);
  }

  @Override
  public void held(Supplier<List<RawMessage>> messages) {
    source.held(messages);
  }

  @Override
  public void history(StreamHistory all) {
    source.history(all);
  }

  @Override
  public void failed(String reason) {
    source.failed(reason);
  }

  @Override
  public void close() {
    source.close();
  }
}
