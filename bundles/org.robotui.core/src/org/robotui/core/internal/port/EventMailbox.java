package org.robotui.core.internal.port;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/**
 * Each one counts: a queue, bounded in number and in the size of the messages, that drops the oldest, and counts what
 * it drops.
 */
final class EventMailbox<T extends Data> implements Mailbox<T> {
  /** A sixth of a second of what comes 50,000 times a second: for so long, a busy machine may not run who takes it. */
  static final int CAPACITY = 8192;
  /** At 300 MB/s a fifth of a second, where the heap may be so large. */
  static final long BYTES = Math.clamp(Runtime.getRuntime().maxMemory() / 32, 32L << 20, 64L << 20);
  /** What a value without a message is taken for. */
  private static final long PLAIN = (32L << 20) / CAPACITY;

  private final Runnable filled;
  private final Queue<Envelope<T>> queue = new ConcurrentLinkedQueue<>();
  private final AtomicInteger size = new AtomicInteger();
  private final AtomicLong bytes = new AtomicLong();
  private final AtomicLong dropped = new AtomicLong();

  /** Nobody is told of what comes. */
  EventMailbox() {
    this(() -> {});
  }

  /** Tells of each value that has come; on the thread that offers it. */
  EventMailbox(Runnable filled) {
    this.filled = filled;
  }

  @Override
  public void offer(Envelope<T> envelope) {
    queue.add(envelope);
    bytes.addAndGet(weight(envelope));
    size.incrementAndGet();
    while (isFull() && poll().isPresent()) {
      dropped.incrementAndGet();
    }
    filled.run();
  }

  /** One value may always wait, however large it is. */
  private boolean isFull() {
    int count = size.get();
    return count > CAPACITY || count > 1 && bytes.get() > BYTES;
  }

  private static long weight(Envelope<?> envelope) {
    return envelope.raw().map(r -> (long) r.bytes().size()).orElse(PLAIN);
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
    next.ifPresent(e -> {
      size.decrementAndGet();
      bytes.addAndGet(-weight(e));
    });
    return next;
  }

  @Override
  public long dropped() {
    return dropped.get();
  }
}
