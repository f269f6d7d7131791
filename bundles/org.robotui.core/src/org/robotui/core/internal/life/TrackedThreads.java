package org.robotui.core.internal.life;

import java.lang.Thread.UncaughtExceptionHandler;
import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Makes the threads of one component and knows which of them live, and which others they started, so that no leak stays
 * unseen.
 */
public final class TrackedThreads implements ThreadFactory {
  private static final long POLL_MILLIS = 5;

  private final String name;
  private final ComponentGroup group;
  private final AtomicInteger count = new AtomicInteger();
  private final Set<Thread> threads = ConcurrentHashMap.newKeySet();

  /**
   * No threads yet.
   *
   * @param name of the component
   * @param handler is told of a thread that threw
   */
  public TrackedThreads(String name, UncaughtExceptionHandler handler) {
    this.name = name;
    this.group = new ComponentGroup(name, handler);
  }

  @Override
  public Thread newThread(Runnable work) {
    Thread thread =
        Thread.ofPlatform().group(group).daemon().name(name + "-" + count.incrementAndGet()).unstarted(work);
    threads.removeIf(t -> t.getState() == Thread.State.TERMINATED);
    threads.add(thread);
    return thread;
  }

  /** Interrupts all and waits for their end; says which of them are left then, or nothing. */
  String endAll(Duration limit) throws InterruptedException {
    interruptAll();
    return awaitNone(limit) ? "" : "; threads left: " + String.join(", ", alive());
  }

  /** The names of those that live. */
  public List<String> alive() {
    return living().stream().map(Thread::getName).sorted().toList();
  }

  private Set<Thread> living() {
    Set<Thread> living = new LinkedHashSet<>(threads);
    Strays.in(group).forEach(living::add);
    living.removeIf(t -> !t.isAlive() || t == Thread.currentThread());
    return living;
  }

  /** Interrupts all. */
  public void interruptAll() {
    living().forEach(Thread::interrupt);
  }

  /** Waits until none lives, or the time is over. */
  public boolean awaitNone(Duration limit) throws InterruptedException {
    long end = System.nanoTime() + limit.toNanos();
    for (Thread thread : living()) {
      long left = (end - System.nanoTime()) / 1_000_000;
      thread.join(Math.max(POLL_MILLIS, left));
    }
    return living().isEmpty();
  }
}
