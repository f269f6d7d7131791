package org.robotui.core.internal.host;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.robotui.api.host.HostListener;
import org.robotui.core.internal.fence.Thrown;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What one listener was not told yet: each thing once, however often it happened. This is the only place between core
 * and the display that makes one of many; one task of a listener waits at most.
 */
final class Pending {
  private static final Logger LOG = LoggerFactory.getLogger(Pending.class);
  /** Where a display hangs, what is told to it is given up beyond this. */
  private static final int MOST = 10_000;

  private final HostListener listener;
  private final Executor executor;
  private final Map<Object, Consumer<HostListener>> events = new LinkedHashMap<>();
  private boolean waits;
  private boolean ended;

  Pending(HostListener listener, Executor executor) {
    this.listener = listener;
    this.executor = executor;
  }

  /**
   * Adds what is to be told, unless it is there already. Never throws, whatever becomes of memory or of a display that
   * has gone: the others are to hear of it, and who tells has more to do. Where it threw for want of memory, robots
   * that were to be stopped went on moving.
   */
  void post(Object key, Consumer<HostListener> event) {
    try {
      if (add(key, event)) {
        executor.execute(this::tell);
      }
    } catch (RuntimeException | Error e) {
      again();
      Thrown.log(LOG, "A listener could not be told", e);
    }
  }

  /** True where a task is needed. */
  private synchronized boolean add(Object key, Consumer<HostListener> event) {
    if (!ended && events.size() < MOST) {
      events.putIfAbsent(key, event);
    }
    boolean needed = !ended && !waits;
    waits = true;
    return needed;
  }

  private void tell() {
    try {
      take().forEach(this::tell);
    } catch (RuntimeException | Error e) {
      again();
      Thrown.log(LOG, "A listener could not be told", e);
    }
  }

  /** No task waits: the next thing that happens makes one, also for what is left. */
  private synchronized void again() {
    waits = false;
  }

  private synchronized List<Consumer<HostListener>> take() {
    List<Consumer<HostListener>> taken = new ArrayList<>(events.values());
    events.clear();
    waits = false;
    return taken;
  }

  private void tell(Consumer<HostListener> event) {
    if (isOver()) {
      return;
    }
    try {
      event.accept(listener);
    } catch (RuntimeException | Error e) { // views are foreign code, which may throw anything
      Thrown.log(LOG, "A listener failed: " + listener.getClass().getName(), e);
    }
  }

  private synchronized boolean isOver() {
    return ended;
  }

  /** Nothing more is told. */
  synchronized void end() {
    ended = true;
    events.clear();
  }
}
