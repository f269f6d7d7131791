package org.robotui.lcm.internal.client;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.robotui.lcm.LcmListener;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.Subscription;
import org.robotui.lcm.SubscriptionOptions;
import org.robotui.net.log.LogThrottle;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One subscription: calls its listener, at once or from its queue. */
final class LiveSubscription implements Subscription {

  private static final Logger LOG = LoggerFactory.getLogger(LiveSubscription.class);

  private final Pattern pattern;
  private final SubscriptionOptions options;
  private final LcmListener listener;
  private final Counters counters;
  private final Consumer<LiveSubscription> onClose;
  private final LongAdder received = new LongAdder();
  private final LongAdder dropped = new LongAdder();
  private final LongAdder errors = new LongAdder();
  private final LogThrottle troubles = new LogThrottle();
  private final Deque<LcmMessage> queue = new ArrayDeque<>();
  private long queuedBytes;
  private volatile boolean closed;

  LiveSubscription(Pattern pattern, SubscriptionOptions options, LcmListener listener, Counters counters,
      Consumer<LiveSubscription> onClose) {
    this.pattern = pattern;
    this.options = options;
    this.listener = listener;
    this.counters = counters;
    this.onClose = onClose;
  }

  boolean matches(String channel) {
    return pattern.matcher(channel).matches();
  }

  boolean isQueued() {
    return options.queue() > 0;
  }

  void deliver(LcmMessage message) {
    if (!isQueued()) {
      call(message);
      return;
    }
    synchronized (queue) {
      queue.addLast(message);
      queuedBytes += message.data().remaining();
      while (queue.size() > options.queue() || queue.size() > 1 && queuedBytes > options.queueBytes()) {
        queuedBytes -= queue.removeFirst().data().remaining();
        dropped.increment();
        counters.dropped();
      }
      queue.notifyAll();
    }
  }

  /** The work of the thread that empties the queue. */
  void work() {
    try {
      for (Optional<LcmMessage> next = take(); next.isPresent(); next = take()) {
        call(next.get());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** The next message; empty once the subscription is closed. */
  private Optional<LcmMessage> take() throws InterruptedException {
    synchronized (queue) {
      while (queue.isEmpty() && !closed) {
        queue.wait();
      }
      Optional<LcmMessage> message = Optional.ofNullable(queue.pollFirst());
      message.ifPresent(taken -> queuedBytes -= taken.data().remaining());
      return message;
    }
  }

  private void call(LcmMessage message) {
    if (closed) {
      return;
    }
    received.increment();
    try {
      listener.onMessage(message);
    } catch (RuntimeException | Error e) {
      errors.increment();
      counters.listenerError();
      if (troubles.admit()) {
        LOG.error("the listener to '{}' failed on a message of {} ({} times so far)", pattern, message.channel(),
            troubles.count(), e);
      }
    }
  }

  @Override
  public String channels() {
    return pattern.pattern();
  }

  @Override
  public long received() {
    return received.sum();
  }

  @Override
  public long dropped() {
    return dropped.sum();
  }

  @Override
  public long listenerErrors() {
    return errors.sum();
  }

  @Override
  public void close() {
    synchronized (queue) {
      closed = true;
      queue.clear();
      queue.notifyAll();
    }
    onClose.accept(this);
  }
}
