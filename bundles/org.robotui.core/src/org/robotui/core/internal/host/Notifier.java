package org.robotui.core.internal.host;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.host.HostListener;
import org.robotui.core.internal.fence.Thrown;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Tells listeners, on a thread of its own. What is told again before a listener took it is told once. */
final class Notifier implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Notifier.class);

  private final List<HostListener> listeners = new CopyOnWriteArrayList<>();
  private final Map<Object, Consumer<HostListener>> pending = new LinkedHashMap<>();
  private boolean closed;

  Notifier() {
    Thread.ofPlatform().daemon().name("robotui-events").start(this::run);
  }

  Subscription listen(HostListener listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  /** Tells something; what has the same key and was not told yet is told once. */
  synchronized void post(Object key, Consumer<HostListener> event) {
    if (!closed && pending.putIfAbsent(key, event) == null) {
      notifyAll();
    }
  }

  private void run() {
    try {
      List<Consumer<HostListener>> events = take();
      while (!events.isEmpty()) {
        events.forEach(this::tell);
        events = take();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Waits; empty where it is closed and all is told. */
  private synchronized List<Consumer<HostListener>> take() throws InterruptedException {
    while (!closed && pending.isEmpty()) {
      wait();
    }
    List<Consumer<HostListener>> events = new ArrayList<>(pending.values());
    pending.clear();
    return events;
  }

  private void tell(Consumer<HostListener> event) {
    for (HostListener listener : listeners) {
      try {
        event.accept(listener);
      } catch (RuntimeException | Error e) { // the others are to hear of it
        Thrown.log(LOG, "A listener failed", e);
      }
    }
  }

  @Override
  public synchronized void close() {
    closed = true;
    notifyAll();
  }
}
