package org.robotui.core.internal.port;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** Each one counts: a bounded queue that drops the oldest, and counts what it drops. */
final class EventMailbox<T extends Data> implements Mailbox<T> {
  static final int CAPACITY = 1024;

  private final Queue<Envelope<T>> queue = new ConcurrentLinkedQueue<>();
  private final AtomicInteger size = new AtomicInteger();
  private final AtomicLong dropped = new AtomicLong();

  @Override
  public void offer(Envelope<T> envelope) {
    queue.add(envelope);
    if (size.incrementAndGet() > CAPACITY && poll().isPresent()) {
      dropped.incrementAndGet();
    }
  }

  @Override
  public int drain(Consumer<? super Envelope<T>> consumer) {
    // Bounded, so that a producer faster than the consumer cannot keep it here for ever.
    int count = 0;
    Optional<Envelope<T>> next = poll();
    while (next.isPresent()) {
      consumer.accept(next.get());
      count++;
      next = count < CAPACITY ? poll() : Optional.empty();
    }
    return count;
  }

  private Optional<Envelope<T>> poll() {
    Optional<Envelope<T>> next = Optional.ofNullable(queue.poll());
    next.ifPresent(e -> size.decrementAndGet());
    return next;
  }

  @Override
  public long dropped() {
    return dropped.get();
  }
}
