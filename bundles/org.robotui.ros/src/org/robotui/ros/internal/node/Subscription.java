package org.robotui.ros.internal.node;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.LongAdder;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageInfo;
import org.robotui.ros.GraphName;
import org.robotui.ros.LinkEvent;
import org.robotui.ros.LinkState;
import org.robotui.ros.MessageListener;
import org.robotui.ros.Reception;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One subscriber with its links, one per publisher. */
final class Subscription<T> implements Subscriber {

  private static final Logger LOG = LoggerFactory.getLogger(Subscription.class);

  private static final int MAX_LINKS = 1024;

  private final NodeContext context;
  private final GraphName topic;
  private final MessageCodec<T> codec;
  private final SubscriberOptions options;
  private final MessageListener<T> listener;
  private final Consumer<Subscription<?>> onClose;
  private final Map<String, InLink<T>> links = new HashMap<>();
  private final ReentrantLock delivering = new ReentrantLock();
  private final LongAdder received = new LongAdder();
  private final LongAdder listenerErrors = new LongAdder();
  private final AtomicReference<Unreadable> unreadable = new AtomicReference<>(Unreadable.NONE);
  private volatile boolean closed;

  Subscription(NodeContext context, GraphName topic, MessageCodec<T> codec, SubscriberOptions options,
      MessageListener<T> listener, Consumer<Subscription<?>> onClose) {
    this.context = context;
    this.topic = topic;
    this.codec = codec;
    this.options = options;
    this.listener = listener;
    this.onClose = onClose;
  }

  /** Takes the publishers the master lists; those it does not list stay while they are connected. */
  synchronized void publishers(Set<String> uris) {
    if (!closed) {
      links.forEach((uri, link) -> {
        if (!uris.contains(uri)) {
          link.orphan();
        }
      });
      uris.forEach(this::publisher);
    }
  }

  /** Each link has a thread: a master that lists publishers without end must not make as many. */
  private boolean isFull(String uri) {
    boolean full = links.size() >= MAX_LINKS;
    if (full) {
      context.report(LinkEvent.Kind.SUBSCRIPTION, topic.text(), uri,
          new LinkState.Closed("topic " + topic + ": publisher " + uri
              + ": there are more than " + MAX_LINKS + " publishers"));
    }
    return full;
  }

  private void publisher(String uri) {
    InLink<T> known = links.get(uri);
    if (known == null && isFull(uri)) {
      return;
    }
    if (known == null) {
      InLink<T> link = new InLink<>(context, this, uri);
      links.put(uri, link);
      link.start();
    } else {
      known.nudge();
    }
  }

  /** Forgets a link that is over; under the lock under which the master's lists revive links. */
  synchronized boolean ended(InLink<T> link, String uri) {
    boolean over = link.isOver();
    if (over) {
      links.remove(uri, link);
    }
    return over;
  }

  void deliver(T value, Reception reception) {
    delivering.lock();
    try {
      if (closed) {
        return;
      }
      received.increment();
      listener.onMessage(value, reception);
    } catch (RuntimeException e) {
      listenerFailed(e);
    } finally {
      delivering.unlock();
    }
  }

  /** Logs the first failures and ever fewer of those that follow. */
  private void listenerFailed(RuntimeException e) {
    listenerErrors.increment();
    long count = listenerErrors.sum();
    if (Long.bitCount(count) == 1) {
      LOG.error("{}: listener of {} failed ({} times so far)", context.name(), topic, count, e);
    }
  }

  ConnectionHeader request() {
    ConnectionHeader header = ConnectionHeader.of(context.name().text()).with(codec.info()).with("topic", topic.text());
    return options.tcpNoDelay() ? header.with("tcp_nodelay", "1") : header;
  }

  MessageInfo info() {
    return codec.info();
  }

  MessageCodec<T> codec() {
    return codec;
  }

  synchronized Collection<InLink<T>> links() {
    return List.copyOf(links.values());
  }

  @Override
  public GraphName topic() {
    return topic;
  }

  @Override
  public int numPublishers() {
    return (int) links().stream().filter(InLink::isConnected).count();
  }

  @Override
  public Set<String> publishers() {
    return links().stream().filter(InLink::isConnected).map(InLink::peer).collect(Collectors.toUnmodifiableSet());
  }

  @Override
  public long received() {
    return received.sum();
  }

  @Override
  public Unreadable unreadable() {
    return unreadable.get();
  }

  /** One more message could not be read. */
  void unreadable(String reason) {
    unreadable.updateAndGet(before -> new Unreadable(before.count() + 1, reason));
  }

  @Override
  public long listenerErrors() {
    return listenerErrors.sum();
  }

  @Override
  public void close() {
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
    }
    onClose.accept(this);
    links().forEach(InLink::close);
  }
}
