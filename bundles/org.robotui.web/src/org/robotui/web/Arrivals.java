package org.robotui.web;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.ThreadFactory;
import java.util.function.Consumer;
import java.util.function.ToLongFunction;
import org.robotui.net.log.LogThrottle;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What has arrived and was not taken yet. One thread takes it, from one source after another, so that a source that
 * floods does not hold up the others; whoever receives only leaves it here, so that the network is always read. Each
 * source keeps only so many, the newest. Safe for all threads.
 */
public final class Arrivals implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(Arrivals.class);

  private final LogThrottle throttle = new LogThrottle();
  private final Deque<Source<?>> ready = new ArrayDeque<>();
  private final Thread taker;
  private boolean closed;

  /**
   * Starts the thread that takes.
   *
   * @param threads makes it
   */
  public Arrivals(ThreadFactory threads) {
    this.taker = threads.newThread(this::take);
    taker.start();
  }

  /**
   * A source of its own.
   *
   * @param most how many are kept; 1 where only the newest counts
   * @param taken is given each, on the thread that takes
   * @param <T> what arrives
   * @return the source
   */
  public <T> Source<T> source(int most, Consumer<? super T> taken) {
    return source(most, Long.MAX_VALUE, value -> 0, taken);
  }

  /**
   * A source of its own, which keeps no more than fits.
   *
   * @param most how many are kept; 1 where only the newest counts
   * @param mostBytes how many bytes are kept, but for one that is longer
   * @param size how long each is, in bytes
   * @param taken is given each, on the thread that takes
   * @param <T> what arrives
   * @return the source
   */
  public <T> Source<T> source(int most, long mostBytes, ToLongFunction<? super T> size, Consumer<? super T> taken) {
    return new Source<>(this, most, mostBytes, size, taken);
  }

  /**
   * Where things arrive that are of one kind. Safe for all threads.
   *
   * @param <T> what arrives
   */
  public static final class Source<T> implements AutoCloseable {
    private final Arrivals all;
    private final int most;
    private final long mostBytes;
    private final ToLongFunction<? super T> size;
    private final Consumer<? super T> taken;
    private final Deque<T> kept = new ArrayDeque<>();
    private long bytes;
    private long dropped;
    private boolean queued;
    private boolean closed;

    private Source(Arrivals all, int most, long mostBytes, ToLongFunction<? super T> size,
        Consumer<? super T> taken) {
      this.all = all;
      this.most = most;
      this.mostBytes = mostBytes;
      this.size = size;
      this.taken = taken;
    }

    /**
     * Leaves something here, in place of the oldest where there is no room. Never blocks for long.
     *
     * @param value what has arrived
     */
    public void arrived(T value) {
      synchronized (all) {
        if (closed || all.closed) {
          return;
        }
        bytes += size.applyAsLong(value);
        while (!kept.isEmpty() && (kept.size() >= most || bytes > mostBytes)) {
          poll();
          dropped++;
        }
        kept.add(value);
        if (!queued) {
          queued = true;
          all.ready.add(this);
          all.notifyAll();
        }
      }
    }

    /** The oldest; under the lock of all. */
    private T poll() {
      T oldest = kept.poll();
      bytes -= size.applyAsLong(oldest);
      return oldest;
    }

    /**
     * How many were dropped since this was asked, as newer ones came before they were taken.
     *
     * @return how many
     */
    public long dropped() {
      synchronized (all) {
        long since = dropped;
        dropped = 0;
        return since;
      }
    }

    /** Nothing of it is taken any more. */
    @Override
    public void close() {
      synchronized (all) {
        closed = true;
        kept.clear();
        bytes = 0;
        all.ready.remove(this);
      }
    }
  }

  private void take() {
    try {
      while (true) {
        takeOne(next());
      }
    } catch (InterruptedException e) {
      // closed
    }
  }

  private synchronized Source<?> next() throws InterruptedException {
    while (ready.isEmpty()) {
      if (closed) {
        throw new InterruptedException();
      }
      wait();
    }
    return ready.poll();
  }

  private <T> void takeOne(Source<T> source) throws InterruptedException {
    T value;
    synchronized (this) {
      if (closed) {
        throw new InterruptedException();
      }
      if (source.closed) {
        return;
      }
      value = source.poll();
      source.queued = !source.kept.isEmpty();
      if (source.queued) {
        ready.add(source);
      }
    }
    try {
      source.taken.accept(value);
    } catch (RuntimeException e) {
      if (throttle.admit()) {
        LOG.error("what has arrived was not taken ({} so far)", throttle.count(), e);
      }
    }
  }

  /** Nothing is taken any more. Does not wait for what is being taken. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      ready.clear();
      notifyAll();
    }
    taker.interrupt();
  }
}
