package org.robotui.core.internal.command;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.locks.LockSupport;
import org.robotui.core.internal.fence.Thrown;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.data.Data;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The thread that sends the commands of one robot interface, so that one that hangs neither delays the arbiter nor the stop
 * of others. A port that hangs is fenced, and a new thread goes on with the others.
 */
public final class Sender implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Sender.class);
  private static final long RETRY_NANOS = 10_000_000L;
  private static final long HANGS_NANOS = Duration.ofSeconds(1).toNanos();

  private record Busy(CommandTarget<?> target, long since) {}

  private final String name;
  private final ThreadFactory threads;
  private final NanoClock clock;
  private final List<CommandTarget<?>> waiting = new ArrayList<>();
  private Optional<Thread> worker = Optional.empty();
  private Optional<Busy> busy = Optional.empty();
  private boolean closed;

  /**
   * A sender without a thread until the first command.
   *
   * @param name for messages
   * @param threads of the robot interface
   * @param clock monotonic
   */
  public Sender(String name, ThreadFactory threads, NanoClock clock) {
    this.name = name;
    this.threads = threads;
    this.clock = clock;
  }

  synchronized <T extends Data> boolean post(CommandTarget<T> target, Outbox.Pending<T> pending) {
    boolean taken = !closed && target.fence().isEmpty() && target.outbox().add(pending);
    if (taken) {
      wake(target);
    }
    return taken;
  }

  synchronized <T extends Data> void postStop(CommandTarget<T> target, Outbox.Pending<T> zero) {
    if (!closed && target.fence().isEmpty()) {
      target.outbox().stop(zero);
      wake(target);
    }
  }

  synchronized void clear(CommandTarget<?> target) {
    target.outbox().clear();
  }

  private void wake(CommandTarget<?> target) {
    if (!waiting.contains(target)) {
      waiting.add(target);
    }
    if (worker.isEmpty()) {
      startWorker();
    }
    notifyAll();
  }

  private void startWorker() {
    Thread thread = threads.newThread(this::run);
    worker = Optional.of(thread);
    thread.start();
  }

  private void run() {
    boolean goesOn = true;
    while (goesOn) {
      goesOn = sendNext();
    }
  }

  /** Where there is no memory even for this, it is tried again: nobody else sends the stop, which the arbiter repeats. */
  private boolean sendNext() {
    try {
      Optional<CommandTarget<?>> next = next();
      next.ifPresent(this::sendOne);
      return next.isPresent();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // it was fenced or closed; the thread ends
      return false;
    } catch (RuntimeException | Error e) {
      Thrown.log(LOG, "Sending to " + name + " failed", e);
      LockSupport.parkNanos(RETRY_NANOS);
      return true;
    }
  }

  private synchronized Optional<CommandTarget<?>> next() throws InterruptedException {
    while (isMine() && waiting.isEmpty()) {
      busy = Optional.empty();
      notifyAll();
      wait();
    }
    if (!isMine()) {
      return Optional.empty();
    }
    CommandTarget<?> target = waiting.stream().filter(t -> t.outbox().hasStop()).findFirst()
        .orElseGet(waiting::getFirst);
    waiting.remove(target);
    busy = Optional.of(new Busy(target, clock.nanos()));
    return Optional.of(target);
  }

  private boolean isMine() {
    return !closed && worker.filter(w -> w == Thread.currentThread()).isPresent();
  }

  private <T extends Data> void sendOne(CommandTarget<T> target) {
    Optional<Outbox.Pending<T>> pending = take(target);
    pending.ifPresent(target::deliver);
  }

  private synchronized <T extends Data> Optional<Outbox.Pending<T>> take(CommandTarget<T> target) {
    Optional<Outbox.Pending<T>> pending = isMine() ? target.outbox().take() : Optional.empty();
    if (!target.outbox().isEmpty() && !waiting.contains(target)) {
      waiting.add(target);
    }
    return pending;
  }

  /** Fences a port that hangs. Called now and then by the watch. Returns what to tell the user. */
  public synchronized Optional<String> check(long now) {
    Optional<Busy> hanging = busy.filter(b -> now - b.since() > HANGS_NANOS);
    return hanging.map(b -> fence(b.target()));
  }

  private String fence(CommandTarget<?> target) {
    String reason = name + " hangs while sending on '" + target.id().port() + "'; nothing more is sent there";
    target.fence(reason);
    waiting.remove(target);
    worker.ifPresent(Thread::interrupt);
    worker = Optional.empty();
    busy = Optional.empty();
    if (!waiting.isEmpty()) {
      startWorker();
    }
    return reason;
  }

  /** Waits until all is sent, or the time is over. */
  public synchronized void flush(Duration limit) throws InterruptedException {
    long end = System.nanoTime() + limit.toNanos();
    long left = limit.toNanos();
    while ((!waiting.isEmpty() || busy.isPresent()) && !closed && left > 0) {
      wait(Math.max(1, left / 1_000_000));
      left = end - System.nanoTime();
    }
  }

  @Override
  public synchronized void close() {
    closed = true;
    worker.ifPresent(Thread::interrupt);
    notifyAll();
  }
}
