package org.robotui.ros.internal.node;

import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.UnaryOperator;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.ros.Reception;

/**
 * Hands what one link brings to all subscribers of its topic, and the last message of a publisher that keeps it also to
 * those who subscribe later: the publisher sends it only once to each link.
 */
final class LinkDelivery {

  private final SubscribedTopic topic;
  private final UnaryOperator<String> describe;
  private final ReentrantLock delivering = new ReentrantLock();
  private final Set<Subscription<?>> waiting = ConcurrentHashMap.newKeySet();
  private volatile Optional<Kept> kept = Optional.empty();

  private record Kept(byte[] frame, Reception reception) {}

  /** @param describe adds to a reason whose messages these are */
  LinkDelivery(SubscribedTopic topic, UnaryOperator<String> describe) {
    this.topic = topic;
    this.describe = describe;
  }

  /**
   * Hands on a message.
   *
   * @throws MessageException with the whole reason, where there are subscribers and none of them can read it
   */
  void deliver(byte[] frame, Reception reception) throws MessageException {
    delivering.lock();
    try {
      if (reception.latched()) {
        kept = Optional.of(new Kept(frame, reception)); // before the subscribers are looked at: see hasKept
      }
      boolean read = false;
      Optional<String> unread = Optional.empty();
      for (Subscription<?> each : topic.subscriptions()) {
        waiting.remove(each);
        Optional<String> problem = deliver(each, frame, reception);
        read |= problem.isEmpty();
        unread = unread.or(() -> problem);
      }
      if (!read && unread.isPresent()) {
        throw new MessageException(unread.get(), "", 0);
      }
    } finally {
      delivering.unlock();
    }
  }

  /** Why it could not be read, where that is so. */
  private Optional<String> deliver(Subscription<?> to, byte[] frame, Reception reception) {
    MessageInfo wanted = to.codec().info();
    String problem;
    if (wanted.accepts(reception.peer().md5())) {
      try {
        to.deliver(frame, reception);
        return Optional.empty();
      } catch (MessageException e) {
        problem = "message that is no " + wanted.type() + ": " + e.getMessage();
      }
    } else {
      problem = to.mismatch(reception.peer());
    }
    String reason = describe.apply(problem);
    to.unreadable(reason);
    return Optional.of(reason);
  }

  /** A subscriber is about to be among those of the topic. */
  void expect(Subscription<?> subscription) {
    waiting.add(subscription);
  }

  /**
   * Whether a subscriber that is now among those of the topic has to {@link #catchUp}. Where it has not, whatever comes
   * from now on is handed to it.
   */
  boolean hasKept(Subscription<?> subscription) {
    boolean has = kept.isPresent();
    if (!has) {
      waiting.remove(subscription);
    }
    return has;
  }

  /** Hands over what is kept, unless something newer has been handed over meanwhile. */
  void catchUp(Subscription<?> subscription) {
    delivering.lock();
    try {
      if (waiting.remove(subscription)) {
        kept.ifPresent(last -> deliver(subscription, last.frame(), last.reception()));
      }
    } finally {
      delivering.unlock();
    }
  }

  /** The link has broken: the publisher sends what it keeps anew when it is made again. */
  void forget() {
    kept = Optional.empty();
  }
}
