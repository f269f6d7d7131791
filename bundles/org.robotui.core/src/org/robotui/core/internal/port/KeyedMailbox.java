package org.robotui.core.internal.port;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** The newest per key wins: a single lock-free slot whose content is merged, with a bounded number of keys. */
final class KeyedMailbox<T extends Data> implements Mailbox<T> {
  private final AtomicReference<Merged<T>> slot = new AtomicReference<>();
  private final AtomicLong dropped = new AtomicLong();

  @Override
  public void offer(Envelope<T> envelope) {
    slot.updateAndGet(held -> Merged.of(held, envelope));
  }

  @Override
  public int drain(Consumer<? super Envelope<T>> consumer) {
    Optional<Merged<T>> next = Optional.ofNullable(slot.getAndSet(null));
    next.ifPresent(merged -> {
      dropped.addAndGet(merged.dropped());
      consumer.accept(merged.envelope());
    });
    return next.isPresent() ? 1 : 0;
  }

  @Override
  public long dropped() {
    return dropped.get() + Optional.ofNullable(slot.get()).map(Merged::dropped).orElse(0L);
  }
}
