package org.robotui.web;

import java.net.http.WebSocket;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;

/**
 * What waits to be sent over one socket. Commands go before all else, and are sent now or not at all; what else is said
 * is queued within bounds. A message that is being sent cannot be overtaken, so these are bounded as well. Safe for all
 * threads.
 */
final class WebOutbox {

  /** Most bytes of one message, behind which a command may have to wait. */
  static final int LONGEST = 1 << 22;
  private static final int MOST_BYTES = 1 << 23;
  private static final int MOST = 1000;

  private final WebSocket socket;
  private final Consumer<Throwable> failed;
  private final Deque<Letter> urgent = new ArrayDeque<>();
  private final Deque<Letter> ordinary = new ArrayDeque<>();
  private long waiting;
  private boolean sending;
  private boolean closed;

  /** A message and how far it has come. */
  private static final class Letter {
    private final WebPayload payload;
    private final int size;
    private boolean begun;
    private boolean sent;

    Letter(WebPayload payload) {
      this.payload = payload;
      this.size = payload.size();
    }
  }

  WebOutbox(WebSocket socket, Consumer<Throwable> failed) {
    this.socket = socket;
    this.failed = failed;
  }

  /** Queues a message; false where there is no room for it, or it is over. */
  boolean add(WebPayload payload) {
    Letter letter = new Letter(payload);
    synchronized (this) {
      if (closed || letter.size > LONGEST || ordinary.size() >= MOST || waiting + letter.size > MOST_BYTES) {
        return false;
      }
      ordinary.add(letter);
      waiting += letter.size;
    }
    pump();
    return true;
  }

  /** Sends before all that waits; one that is not on its way in time is taken back. */
  boolean command(WebPayload payload, Duration patience) throws InterruptedException {
    Letter letter = new Letter(payload);
    synchronized (this) {
      if (closed || letter.size > LONGEST) {
        return false;
      }
      urgent.add(letter);
    }
    pump();
    synchronized (this) {
      try {
        await(patience, letter);
        return letter.begun && !closed;
      } finally {
        urgent.remove(letter); // true only of one that has not begun
      }
    }
  }

  private void await(Duration patience, Letter letter) throws InterruptedException {
    long deadline = System.nanoTime() + patience.toNanos();
    for (long left = patience.toNanos(); !letter.sent && !closed && left > 0; left = deadline - System.nanoTime()) {
      wait(left / 1_000_000, (int) (left % 1_000_000));
    }
  }

  /** Waits until all has been sent, or the time is over. */
  synchronized void drain(Duration patience) throws InterruptedException {
    long deadline = System.nanoTime() + patience.toNanos();
    for (long left = patience.toNanos(); left > 0 && !closed
        && (sending || !ordinary.isEmpty() || !urgent.isEmpty()); left = deadline - System.nanoTime()) {
      wait(left / 1_000_000, (int) (left % 1_000_000));
    }
  }

  synchronized void close() {
    closed = true;
    urgent.clear();
    ordinary.clear();
    waiting = 0;
    notifyAll();
  }

  private void pump() {
    Letter letter;
    synchronized (this) {
      if (sending || closed || urgent.isEmpty() && ordinary.isEmpty()) {
        return;
      }
      letter = next();
      letter.begun = true;
      sending = true;
    }
    letter.payload.send(socket).whenComplete((done, error) -> ended(letter, error));
  }

  private Letter next() {
    if (!urgent.isEmpty()) {
      return urgent.poll();
    }
    Letter letter = ordinary.poll();
    waiting -= letter.size;
    return letter;
  }

  private void ended(Letter letter, Throwable error) {
    synchronized (this) {
      sending = false;
      letter.sent = true;
      notifyAll();
    }
    if (error == null) {
      pump();
    } else {
      failed.accept(error);
    }
  }
}
