package org.robotui.web;

import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.time.Duration;

/**
 * Asks the peer for a sign of life, one question at a time. How long an answer takes tells how much waits before it on
 * its way here; silence means that nothing at all comes. Safe for all threads.
 */
final class LinkHeartbeat {

  private static final Duration PERIOD = Duration.ofMillis(250);

  private final WebSocket socket;
  private boolean asked;
  private long askedAt;
  private long heardAt = System.nanoTime();
  private long roundTrip;

  LinkHeartbeat(WebSocket socket) {
    this.socket = socket;
  }

  void beat(long now) {
    synchronized (this) {
      if (asked || now - askedAt < PERIOD.toNanos()) {
        return;
      }
      asked = true;
      askedAt = now;
    }
    socket.sendPing(ByteBuffer.allocate(0));
  }

  synchronized void answered(long now) {
    if (asked) {
      asked = false;
      roundTrip = now - askedAt;
    }
    heardAt = now;
  }

  synchronized void heard(long now) {
    heardAt = now;
  }

  synchronized long silentNanos(long now) {
    return asked ? Math.max(0, now - Math.max(askedAt, heardAt)) : 0;
  }

  /** Of the latest answer, or longer where one is still awaited. */
  synchronized long roundTripNanos(long now) {
    return asked ? Math.max(roundTrip, now - askedAt) : roundTrip;
  }
}
