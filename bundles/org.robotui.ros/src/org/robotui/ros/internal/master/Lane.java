package org.robotui.ros.internal.master;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import org.robotui.net.thread.Workers;

/** Runs tasks in turn, on a bounded number of threads that end when there is nothing to do. */
final class Lane {

  private final Workers workers;
  private final String name;
  private final int most;
  private final Queue<Runnable> ready = new ArrayDeque<>();
  private int threads;

  Lane(Workers workers, String name, int most) {
    this.workers = workers;
    this.name = name;
    this.most = most;
  }

  synchronized void execute(Runnable task) {
    ready.add(task);
    if (threads < most) {
      workers.start(name, this::run);
      threads++;
    }
  }

  private void run() {
    for (Optional<Runnable> next = take(); next.isPresent(); next = take()) {
      next.get().run();
    }
  }

  private synchronized Optional<Runnable> take() {
    Optional<Runnable> next = Optional.ofNullable(ready.poll());
    if (next.isEmpty()) {
      threads--;
    }
    return next;
  }

  synchronized void clear() {
    ready.clear();
  }
}
