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
 * The thread that sends the commands of one robot interface, so that one that hangs neither delays the arbiter nor the
 * stop of others. A port that hangs is fenced, and a new thread goes on with the others.
 */
public final class Sender implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Sender.class);
  private static final long RETRY_NANOS = 10_000_000L;
  private static final long HANGS_NANOS = Duration.ofSeconds(1).toNanos();

  private record Busy(Outbox<?> outbox, long since) {}

  private final String name;
  private final ThreadFactory threads;
  private final NanoClock clock;
  private final List<Outbox<?>> waiting = new ArrayList<>();
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

  /** Adds a command; false where nothing is sent there any more, or too many wait. */
  synchronized <T extends Data> boolean post(Outbox<T> outbox, Outbox.Pending<T> pending) {
    boolean taken = !closed && outbox.fence().isEmpty() && outbox.add(pending);
    if (taken) {
      wake(outbox);
    }
    return taken;
  }

  /** Puts a stop before all else. */
  synchronized <T extends Data> void postStop(Outbox<T> outbox, Outbox.Pending<T> zero) {
    if (!closed && outbox.fence().isEmpty()) {
      outbox.stop(zero);
      wake(outbox);
    }
  }

  /** Forgets what was not sent yet, save a stop. */
  synchronized void clear(Outbox<?> outbox) {
    outbox.clear();
  }

  private void wake(Outbox<?> outbox) {
    if (!waiting.contains(outbox)) {
      waiting.add(outbox);
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

  /**
   * Where there is no memory even for this, it is tried again: nobody else sends the stop, which the arbiter repeats.
   */
  private boolean sendNext() {
    try {
      Optional<Outbox<?>> next = next();
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

  private synchronized Optional<Outbox<?>> next() throws InterruptedException {
    while (isMine() && waiting.isEmpty()) {
      busy = Optional.empty();
      notifyAll();
      wait();
    }
    if (!isMine()) {
      return Optional.empty();
    }
    Outbox<?> outbox = waiting.stream().filter(Outbox::hasStop).findFirst().orElseGet(waiting::getFirst);
    waiting.remove(outbox);
    busy = Optional.of(new Busy(outbox, clock.nanos()));
    return Optional.of(outbox);
  }

  private boolean isMine() {
    return !closed && worker.filter(w -> w == Thread.currentThread()).isPresent();
  }

  private <T extends Data> void sendOne(Outbox<T> outbox) {
    Optional<Outbox.Pending<T>> pending = take(outbox);
    pending.ifPresent(outbox::deliver);
  }

  private synchronized <T extends Data> Optional<Outbox.Pending<T>> take(Outbox<T> outbox) {
    Optional<Outbox.Pending<T>> pending = isMine() ? outbox.take() : Optional.empty();
    if (!outbox.isEmpty() && !waiting.contains(outbox)) {
      waiting.add(outbox);
    }
    return pending;
  }

  /** Fences a port that hangs. Called now and then by the watch. Returns what to tell the user. */
  public synchronized Optional<String> check(long now) {
    Optional<Busy> hanging = busy.filter(b -> now - b.since() > HANGS_NANOS);
    return hanging.map(b -> fence(b.outbox()));
  }

  private String fence(Outbox<?> outbox) {
    String reason = name + " hangs while sending on '" + outbox.port() + "'; nothing more is sent there";
    outbox.fence(reason);
    waiting.remove(outbox);
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
