package org.robotui.rtps.internal.discovery;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.robotui.net.log.LogThrottle;
import org.robotui.rtps.DiscoveryListener;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Tells listeners one thing after another, in order, and without a lock that they could wait for: what happens is
 * queued under the lock of the caller, and told by whoever comes first after that lock was released.
 */
final class Listeners {

  private static final Logger LOG = LoggerFactory.getLogger(Listeners.class);

  private final List<DiscoveryListener> listeners = new CopyOnWriteArrayList<>();

  private final Deque<Runnable> events = new ArrayDeque<>();

  private final LogThrottle faults = new LogThrottle();

  private boolean telling;

  /** Adds a listener, and what it is to be told first. */
  synchronized void add(DiscoveryListener listener, List<Consumer<DiscoveryListener>> past) {
    listeners.add(listener);
    past.forEach(event -> events.add(() -> tell(listener, event)));
  }

  void remove(DiscoveryListener listener) {
    listeners.remove(listener);
  }

  /** Queues what all who are listeners now are to be told. */
  synchronized void queue(Consumer<DiscoveryListener> event) {
    List<DiscoveryListener> now = List.copyOf(listeners);
    if (!now.isEmpty()) {
      events.add(() -> now.forEach(listener -> tell(listener, event)));
    }
  }

  private void tell(DiscoveryListener listener, Consumer<DiscoveryListener> event) {
    if (!listeners.contains(listener)) {
      return; // removed meanwhile
    }
    try {
      event.accept(listener);
    } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
      if (faults.admit()) {
        LOG.error("a listener of discovery threw ({} times so far)", faults.count(), e);
      }
    }
  }

  /** Tells what is queued. Returns at once where another thread, or a call above this one, is doing it. */
  void tellAll() {
    synchronized (this) {
      if (telling) {
        return;
      }
      telling = true;
    }
    boolean done = false;
    try {
      for (Runnable event = next(); event != null; event = next()) {
        event.run();
      }
      done = true;
    } finally {
      if (!done) {
        stop(); // an error that is nobody's to catch: others go on telling
      }
    }
  }

  private synchronized void stop() {
    telling = false;
  }

  private synchronized Runnable next() {
    Runnable event = events.poll();
    telling = event != null;
    return event;
  }
}
