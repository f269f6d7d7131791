package org.robotui.core.internal.port;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** The newest wins: a single lock-free slot. */
final class SampleMailbox<T extends Data> implements Mailbox<T> {
  private final AtomicReference<Envelope<T>> slot = new AtomicReference<>();
  private volatile long taken = -1;

  @Override
  public void offer(Envelope<T> envelope) {
    if (envelope.sequence() > taken) {
      slot.accumulateAndGet(envelope, Envelopes::newest);
    }
  }

  @Override
  public int drain(Consumer<? super Envelope<T>> consumer) {
    // A value published by another thread just before the one already taken is older and must not come after it.
    Optional<Envelope<T>> next = Optional.ofNullable(slot.getAndSet(null)).filter(e -> e.sequence() > taken);
    next.ifPresent(e -> taken = e.sequence());
    next.ifPresent(consumer);
    return next.isPresent() ? 1 : 0;
  }

  @Override
  public long dropped() {
    return 0;
  }
}
