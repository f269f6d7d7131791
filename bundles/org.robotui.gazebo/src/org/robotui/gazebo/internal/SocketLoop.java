package org.robotui.gazebo.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Pipe;
import java.util.Queue;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.zeromq.ZMQ;

/**
 * The one thread that uses sockets of ZeroMQ, which no two threads may use at once. Others leave it work; what they
 * leave is bounded.
 */
final class SocketLoop {
  private static final Logger LOG = LoggerFactory.getLogger(SocketLoop.class);
  private static final int MOST_WORK = 10_000;
  private static final int LOOK_MILLIS = 100;
  private static final int SOON_MILLIS = 10;

  private final Queue<Runnable> work = new ArrayBlockingQueue<>(MOST_WORK);
  private final AtomicBoolean woken = new AtomicBoolean();
  private final Pipe pipe;
  private volatile boolean over;

  /** What the loop does when it was not woken. */
  interface Turn {
    /** Reads what has come of some of the sockets; answers whether to look again soon, whatever comes. */
    boolean take(ZMQ.Poller poller);
  }

  SocketLoop() throws IOException {
    this.pipe = Pipe.open();
    pipe.source().configureBlocking(false);
    pipe.sink().configureBlocking(false);
  }

  /** Leaves work to be done soon; answers whether there is room for it. */
  boolean leave(Runnable some) {
    boolean taken = !over && work.offer(some);
    wake();
    return taken;
  }

  private void wake() {
    if (!woken.getAndSet(true)) {
      try {
        pipe.sink().write(ByteBuffer.allocate(1));
      } catch (IOException e) {
        // it looks by itself some milliseconds later
      }
    }
  }

  /** Runs on the thread of the loop until the end. */
  void run(ZMQ.Poller poller, Turn turn) {
    poller.register(pipe.source(), ZMQ.Poller.POLLIN);
    boolean soon = false;
    while (!over) {
      poller.poll(soon ? SOON_MILLIS : LOOK_MILLIS);
      drain();
      for (Runnable next = work.poll(); next != null; next = work.poll()) {
        attempt(next);
      }
      soon = turn.take(poller);
    }
    for (Runnable next = work.poll(); next != null; next = work.poll()) {
      attempt(next);
    }
  }

  private void drain() {
    woken.set(false);
    try {
      ByteBuffer bytes = ByteBuffer.allocate(Byte.SIZE);
      while (pipe.source().read(bytes.clear()) > 0) {
        // only that something was written matters
      }
    } catch (IOException e) {
      LOG.debug("a pipe of this process cannot be read", e);
    }
  }

  private static void attempt(Runnable next) {
    try {
      next.run();
    } catch (RuntimeException e) {
      LOG.warn("a socket refused what was to be done: {}", e.toString());
    }
  }

  /** Ends after what was left; any thread may call it. */
  void end() {
    over = true;
    wake();
  }

  void close() {
    try {
      pipe.sink().close();
      pipe.source().close();
    } catch (IOException e) {
      LOG.debug("a pipe of this process cannot be closed", e);
    }
  }
}
