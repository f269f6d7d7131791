package org.robotui.ros.internal.node;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.LongAdder;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.ros.GraphName;
import org.robotui.ros.MessageListener;
import org.robotui.ros.Reception;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One subscriber, which has the links of its topic together with others. */
final class Subscription<T> implements Subscriber {

  private static final Logger LOG = LoggerFactory.getLogger(Subscription.class);

  private final NodeContext context;
  private final SubscribedTopic topic;
  private final MessageCodec<T> codec;
  private final SubscriberOptions options;
  private final MessageListener<T> listener;
  private final Consumer<Subscription<?>> onClose;
  private final ReentrantLock delivering = new ReentrantLock();
  private final LongAdder received = new LongAdder();
  private final LongAdder listenerErrors = new LongAdder();
  private final AtomicReference<Unreadable> unreadable = new AtomicReference<>(Unreadable.NONE);
  private volatile boolean closed;

  Subscription(NodeContext context, SubscribedTopic topic, MessageCodec<T> codec, SubscriberOptions options,
      MessageListener<T> listener, Consumer<Subscription<?>> onClose) {
    this.context = context;
    this.topic = topic;
    this.codec = codec;
    this.options = options;
    this.listener = listener;
    this.onClose = onClose;
  }

  /** Takes a message of a publisher. */
  void deliver(byte[] frame, Reception reception) throws MessageException {
    T value = decode(ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN), reception.peer());
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

  /** A codec must not let an unchecked exception out, but one that does must not end the thread of the link. */
  private T decode(ByteBuffer frame, MessageInfo theirs) throws MessageException {
    try {
      return codec.decode(frame, theirs);
    } catch (RuntimeException e) {
      MessageException wrapped = new MessageException("decoding failed with " + e, "", frame.position());
      wrapped.initCause(e);
      throw wrapped;
    }
  }

  /** How what a publisher sends differs from what is wanted here. */
  String mismatch(MessageInfo theirs) {
    MessageInfo ours = codec.info();
    return "it sends " + theirs.type() + " with MD5 sum " + theirs.md5() + ", expected " + ours.type() + " with "
        + ours.md5();
  }

  /** Logs the first failures and ever fewer of those that follow. */
  private void listenerFailed(RuntimeException e) {
    listenerErrors.increment();
    long count = listenerErrors.sum();
    if (Long.bitCount(count) == 1) {
      LOG.error("{}: listener of {} failed ({} times so far)", context.name(), topic(), count, e);
    }
  }

  MessageCodec<T> codec() {
    return codec;
  }

  SubscriberOptions options() {
    return options;
  }

  /** The links that bring what is wanted here. */
  private Stream<InLink> sources() {
    return topic.links().stream().filter(link -> link.brings(codec.info()));
  }

  @Override
  public GraphName topic() {
    return topic.topic();
  }

  @Override
  public int numPublishers() {
    return closed ? 0 : (int) sources().count();
  }

  @Override
  public Set<String> publishers() {
    return closed ? Set.of() : sources().map(InLink::peer).collect(Collectors.toUnmodifiableSet());
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
  }
}
