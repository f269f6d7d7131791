package org.robotui.core.internal.host;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.host.HostListener;
import org.robotui.core.internal.life.SharedThreads;

/** Tells listeners, each where it wants to be told: on the display thread, or on a thread that the others share. */
final class Notifier implements AutoCloseable {
  private final List<Pending> listeners = new CopyOnWriteArrayList<>();
  private final ExecutorService shared = Executors.newSingleThreadExecutor(new SharedThreads("robotui-events"));
  private boolean closed;

  Subscription listen(HostListener listener) {
    return listen(listener, shared);
  }

  Subscription listen(HostListener listener, Executor executor) {
    Pending pending = new Pending(listener, executor);
    listeners.add(pending);
    return () -> {
      listeners.remove(pending);
      pending.end();
    };
  }

  /** Tells something; what has the same key and was not told yet is told once. */
  synchronized void post(Object key, Consumer<HostListener> event) {
    if (!closed) {
      listeners.forEach(listener -> listener.post(key, event));
    }
  }

  /** What was posted is still told. */
  @Override
  public synchronized void close() {
    closed = true;
    shared.shutdown();
  }
}
