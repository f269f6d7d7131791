package org.robotui.ros.internal.xmlrpc;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicLong;

/**
 * The memory that the large bodies of all connections of a server may take together. Small ones are free, as the number
 * of connections bounds them: whoever sends large ones cannot keep others from being answered.
 */
final class BodyBudget {

  /** What each message may take in any case, bytes. */
  static final int FREE = 64 * 1024;

  private final long most;
  private final AtomicLong taken = new AtomicLong();

  BodyBudget(long most) {
    this.most = most;
  }

  /** There is no memory for this body now; the call may be made again later. */
  static final class SpentException extends IOException {

    private static final long serialVersionUID = 1L;

    SpentException(int wanted, long most) {
      super("no room for a body of " + wanted + " bytes: the bodies of all connections may take " + most
          + " bytes together; try again later");
    }
  }

  /** What one message takes, until it is answered. Used by one thread. */
  final class Share implements AutoCloseable {

    private long held;

    /** Before the body grows to a size. */
    void grow(int bytes) throws SpentException {
      long more = Math.max(0, bytes <= FREE ? 0 : bytes - held);
      if (taken.addAndGet(more) > most) {
        taken.addAndGet(-more);
        throw new SpentException(bytes, most);
      }
      held += more;
    }

    @Override
    public void close() {
      taken.addAndGet(-held);
      held = 0;
    }
  }

  Share share() {
    return new Share();
  }

  /** How much is taken now. */
  long taken() {
    return taken.get();
  }
}
