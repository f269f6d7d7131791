package org.robotui.ros.internal.node;

import java.net.SocketTimeoutException;
import java.time.Duration;

/** The end of the time a caller gave. */
record Deadline(long nanoTime) {

  static Deadline in(Duration time) {
    return new Deadline(System.nanoTime() + time.toNanos());
  }

  /** What is left, always positive. */
  Duration left() throws SocketTimeoutException {
    long left = nanoTime - System.nanoTime();
    if (left <= 0) {
      throw new SocketTimeoutException("timed out");
    }
    return Duration.ofNanos(left);
  }
}
