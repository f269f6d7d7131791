package org.robotui.core.internal.port;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** The newest per key wins: a single lock-free slot whose content is merged. */
final class KeyedMailbox<T extends Data> implements Mailbox<T> {
  private final AtomicReference<Envelope<T>> slot = new AtomicReference<>();

  @Override
  public void offer(Envelope<T> envelope) {
    slot.accumulateAndGet(envelope, Envelopes::merged);
  }

  @Override
  public int drain(Consumer<? super Envelope<T>> consumer) {
    Optional<Envelope<T>> next = Optional.ofNullable(slot.getAndSet(null));
    next.ifPresent(consumer);
    return next.isPresent() ? 1 : 0;
  }

  @Override
  public long dropped() {
    return 0;
  }
}
