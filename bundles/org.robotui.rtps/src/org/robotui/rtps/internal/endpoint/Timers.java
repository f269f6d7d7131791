package org.robotui.rtps.internal.endpoint;

import java.time.Duration;
import java.util.TreeSet;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.robotui.net.log.LogThrottle;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What is to be done later. One thread of a participant runs it ({@link #runDue}); any thread may ask for something to
 * be done sooner. It holds no lock while a task runs.
 */
public final class Timers {

  /** The time of what is not to be done. */
  public static final long NEVER = Long.MAX_VALUE;

  private static final Logger LOG = LoggerFactory.getLogger(Timers.class);
  private static final long AFTER_FAULT = Duration.ofMillis(500).toNanos();

  private final LogThrottle faults = new LogThrottle();
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition sooner = lock.newCondition();
  private final TreeSet<Timer> waiting = new TreeSet<>();
  private final Clock clock;
  private long made;
  private boolean closed;

  /** The time that tasks go by, in nanoseconds, never negative. */
  @FunctionalInterface
  public interface Clock {

    /** The time now. */
    long nanos();

    /** The clock of this machine since its first use here. */
    static Clock system() {
      long origin = System.nanoTime();
      return () -> System.nanoTime() - origin;
    }
  }

  /** Something that is done again and again. */
  @FunctionalInterface
  public interface Task {

    /** Does what is due and says when it wants to be called next, or {@link #NEVER}. */
    long run(long now);
  }

  /** When a task is to be called. */
  public final class Timer implements Comparable<Timer> {
    private final Task task;
    private final long number;
    private volatile long due = NEVER; // written with the lock held
    private boolean cancelled;

    private Timer(Task task, long number) {
      this.task = task;
      this.number = number;
    }

    /** Calls the task no later than at this time. */
    public void wake(long at) {
      if (at >= due) {
        return; // most of what comes wakes nobody sooner, and needs no lock to find that out
      }
      lock.lock();
      try {
        if (at < due && !cancelled) {
          waiting.remove(this);
          due = at;
          waiting.add(this);
          if (waiting.first() == this) {
            sooner.signal();
          }
        }
      } finally {
        lock.unlock();
      }
    }

    /** Calls it no more, but what is running now. */
    public void cancel() {
      lock.lock();
      try {
        cancelled = true;
        waiting.remove(this);
      } finally {
        lock.unlock();
      }
    }

    @Override
    public int compareTo(Timer other) {
      int first = Long.compare(due, other.due);
      return first != 0 ? first : Long.compare(number, other.number);
    }
  }

  /** Goes by a clock. */
  public Timers(Clock clock) {
    this.clock = clock;
  }

  /** The time now. */
  public long now() {
    return clock.nanos();
  }

  /** A timer that is not yet set. */
  public Timer timer(Task task) {
    lock.lock();
    try {
      return new Timer(task, made++);
    } finally {
      lock.unlock();
    }
  }

  /** Calls what is due and says when the next one is, or {@link #NEVER}. */
  public long runDue() {
    for (Timer timer = takeDue(); timer != null; timer = takeDue()) {
      timer.wake(run(timer));
    }
    lock.lock();
    try {
      return waiting.isEmpty() ? NEVER : waiting.first().due;
    } finally {
      lock.unlock();
    }
  }

  /** One that throws is tried again, as others wait for what it does. */
  private long run(Timer timer) {
    try {
      return timer.task.run(clock.nanos());
    } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
      if (faults.admit()) {
        LOG.error("what was due threw ({} times so far)", faults.count(), e);
      }
      return clock.nanos() + AFTER_FAULT;
    }
  }

  private Timer takeDue() {
    lock.lock();
    try {
      if (closed || waiting.isEmpty() || waiting.first().due > clock.nanos()) {
        return null;
      }
      Timer timer = waiting.pollFirst();
      timer.due = NEVER;
      return timer;
    } finally {
      lock.unlock();
    }
  }

  /** Blocks until something is due. False when it was closed. */
  public boolean await() throws InterruptedException {
    lock.lock();
    try {
      while (!closed) {
        long left = waiting.isEmpty() ? NEVER : waiting.first().due - clock.nanos();
        if (left <= 0) {
          return true;
        }
        sooner.awaitNanos(left);
      }
      return false;
    } finally {
      lock.unlock();
    }
  }

  /** Calls nothing more, but what is running now. */
  public void close() {
    lock.lock();
    try {
      closed = true;
      sooner.signalAll();
    } finally {
      lock.unlock();
    }
  }
}
