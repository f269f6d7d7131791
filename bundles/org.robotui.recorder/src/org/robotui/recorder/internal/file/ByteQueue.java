package org.robotui.recorder.internal.file;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.robotui.recorder.internal.capture.Captured;

/** Messages that wait for the disk, bounded by their size. Whoever brings one never waits. */
final class ByteQueue {
  private final long most;
  private final Deque<Captured> waiting = new ArrayDeque<>();
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition more = lock.newCondition();
  private long bytes;
  private boolean ended;

  ByteQueue(long most) {
    this.most = most;
  }

  /** Whether there was room. One message has always room, however large it is. */
  boolean offer(Captured message) {
    lock.lock();
    try {
      if (ended || !waiting.isEmpty() && bytes + message.weight() > most) {
        return false;
      }
      waiting.add(message);
      bytes += message.weight();
      more.signal();
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** The next one, or nothing where none comes for a while. */
  Optional<Captured> poll(long millis) throws InterruptedException {
    lock.lock();
    try {
      long left = TimeUnit.MILLISECONDS.toNanos(millis);
      while (waiting.isEmpty() && !ended && left > 0) {
        left = more.awaitNanos(left);
      }
      Optional<Captured> next = Optional.ofNullable(waiting.poll());
      next.ifPresent(message -> bytes -= message.weight());
      return next;
    } finally {
      lock.unlock();
    }
  }

  /** Takes nothing more. */
  void end() {
    lock.lock();
    try {
      ended = true;
      more.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Whether nothing more will come. */
  boolean isOver() {
    lock.lock();
    try {
      return ended && waiting.isEmpty();
    } finally {
      lock.unlock();
    }
  }
}
