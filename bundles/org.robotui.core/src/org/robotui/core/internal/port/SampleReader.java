package org.robotui.core.internal.port;

import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** The newest wins: the source remembers it anyway, so nothing is held here but how far this consumer has read. */
final class SampleReader<T extends Data> implements TapReader<T> {
  private final Fan<T> fan;
  private volatile long taken;
  private volatile boolean closed;

  /** Reads values from a sequence number on. */
  SampleReader(Fan<T> fan, long since) {
    this.fan = fan;
    this.taken = since - 1;
  }

  @Override
  public int drain(Consumer<? super Envelope<T>> consumer) {
    Optional<Envelope<T>> next = fan.last().filter(e -> e.sequence() > taken && !closed);
    next.ifPresent(e -> taken = e.sequence());
    next.ifPresent(consumer);
    return next.isPresent() ? 1 : 0;
  }

  @Override
  public long dropped() {
    return 0;
  }

  @Override
  public void close() {
    closed = true;
  }
}
