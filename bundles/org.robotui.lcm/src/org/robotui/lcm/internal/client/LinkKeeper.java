package org.robotui.lcm.internal.client;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.net.call.Backoff;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Opens a link, lets it receive, and opens it again when it broke. */
final class LinkKeeper {

  private static final Logger LOG = LoggerFactory.getLogger(LinkKeeper.class);

  private final Provider provider;
  private final LcmOptions options;
  private final Subscriptions subscriptions;
  private final CountDownLatch closing = new CountDownLatch(1);
  private final Object lock = new Object();
  private Optional<Link> link = Optional.empty();
  private Optional<Thread> opener = Optional.empty();
  private volatile LcmState state = new LcmState.Connecting();

  LinkKeeper(Provider provider, LcmOptions options, Subscriptions subscriptions) {
    this.provider = provider;
    this.options = options;
    this.subscriptions = subscriptions;
  }

  /** The work of the connection's thread. */
  void run() {
    Backoff backoff = new Backoff(options.minBackoff(), options.maxBackoff());
    while (!isClosed()) {
      tell(new LcmState.Connecting());
      String reason;
      try (Link open = open()) {
        if (!take(open)) {
          return;
        }
        backoff.reset();
        tell(new LcmState.Connected(open.where()));
        tell(new LcmState.Ended(open.receive()));
        return;
      } catch (IOException | RuntimeException | OutOfMemoryError e) {
        if (isClosed()) {
          return;
        }
        LOG.debug("the link broke", e);
        reason = Optional.ofNullable(e.getMessage()).orElse(e.toString());
      } finally {
        synchronized (lock) {
          link = Optional.empty();
        }
      }
      failed(reason, backoff.next());
    }
  }

  /** While it opens, and only then, the thread is interrupted by a close. */
  private Link open() throws IOException {
    synchronized (lock) {
      opener = Optional.of(Thread.currentThread());
    }
    try {
      return provider.open();
    } finally {
      synchronized (lock) {
        opener = Optional.empty();
        Thread.interrupted(); // one that came too late
      }
    }
  }

  /** Tells of it, and waits. */
  private void failed(String reason, Duration pause) {
    tell(new LcmState.Failed(reason, pause));
    try {
      closing.await(pause.toNanos(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      closing.countDown();
    }
  }

  private boolean take(Link open) throws IOException {
    synchronized (lock) {
      if (isClosed()) {
        return false;
      }
      link = Optional.of(open);
      for (LiveSubscription each : subscriptions.all()) {
        open.subscribed(each.channels());
      }
      return true;
    }
  }

  private void tell(LcmState now) {
    if (isClosed()) {
      return;
    }
    state = now;
    options.states().onState(now);
  }

  LcmState state() {
    return state;
  }

  Optional<Link> present() {
    synchronized (lock) {
      return link;
    }
  }

  /** The link, to send on it. */
  Link link() throws IOException {
    return present().orElseThrow(() -> new IOException(switch (state) {
      case LcmState.Failed failed -> "not connected, " + failed.reason();
      case LcmState.Ended ended -> ended.reason();
      case LcmState.Closed closed -> "closed";
      default -> "not connected yet";
    }));
  }

  void subscribed(String channels) {
    synchronized (lock) {
      link.ifPresent(open -> ask(() -> open.subscribed(channels)));
    }
  }

  void unsubscribed(String channels) {
    synchronized (lock) {
      link.ifPresent(open -> ask(() -> open.unsubscribed(channels)));
    }
  }

  /** Something a link is asked to do. */
  @FunctionalInterface
  private interface Request {
    void run() throws IOException;
  }

  /** A link that cannot do it is about to break, and what subscribed is told to the next one. */
  private static void ask(Request request) {
    try {
      request.run();
    } catch (IOException e) {
      LOG.debug("the link breaks", e);
    }
  }

  private boolean isClosed() {
    return closing.getCount() == 0;
  }

  void close() {
    closing.countDown();
    synchronized (lock) {
      opener.ifPresent(Thread::interrupt);
    }
    present().ifPresent(open -> ask(open::close));
    state = new LcmState.Closed();
    options.states().onState(state);
  }
}
