package org.robotui.ros.internal.tcpros;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.List;
import java.util.concurrent.atomic.LongAdder;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/** The messages that wait for one subscriber. When it is full the oldest ones go, and are counted. */
public final class OutQueue {

  private static final int MAX_BATCH = 256;

  private final int maxMessages;
  private final long maxBytes;
  private final LongAdder dropped;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final ArrayDeque<ByteBuffer> frames = new ArrayDeque<>();
  private long bytes;
  private boolean waiting;
  private boolean closed;

  public OutQueue(int maxMessages, long maxBytes, LongAdder dropped) {
    this.maxMessages = maxMessages;
    this.maxBytes = maxBytes;
    this.dropped = dropped;
  }

  /** Adds a frame; never waits for the subscriber. */
  public void offer(ByteBuffer frame) {
    lock.lock();
    try {
      while (!frames.isEmpty() && (frames.size() >= maxMessages || bytes + frame.remaining() > maxBytes)) {
        bytes -= frames.poll().remaining();
        dropped.increment();
      }
      frames.add(frame);
      bytes += frame.remaining();
      if (waiting) {
        changed.signal();
      }
    } finally {
      lock.unlock();
    }
  }

  /** Adds a frame and drops, and counts, all that waited. */
  public void offerAlone(ByteBuffer frame) {
    lock.lock();
    try {
      dropped.add(frames.size());
      frames.clear();
      bytes = 0;
      offer(frame);
    } finally {
      lock.unlock();
    }
  }

  /** Waits for frames and moves a batch of them into the list; answers false once closed. */
  public boolean take(List<ByteBuffer> batch) throws InterruptedException {
    lock.lock();
    try {
      awaitFrames();
      for (int i = 0; i < MAX_BATCH && !frames.isEmpty(); i++) {
        ByteBuffer frame = frames.poll();
        bytes -= frame.remaining();
        batch.add(frame);
      }
      return !closed;
    } finally {
      lock.unlock();
    }
  }

  private void awaitFrames() throws InterruptedException {
    waiting = true;
    while (frames.isEmpty() && !closed) {
      changed.await();
    }
    waiting = false;
  }

  /**
   * Whether nothing waits and whoever takes the frames is done with those that it took; so it is for ever when closed.
   */
  public boolean isIdle() {
    lock.lock();
    try {
      return closed || frames.isEmpty() && waiting;
    } finally {
      lock.unlock();
    }
  }

  public void close() {
    lock.lock();
    try {
      closed = true;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }
}
