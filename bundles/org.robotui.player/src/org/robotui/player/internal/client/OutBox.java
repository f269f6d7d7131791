package org.robotui.player.internal.client;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.player.wire.DeviceId;

/**
 * What waits for the socket: requests in their order, and of each command the newest only. Commands go first, so that a
 * stop does not wait behind questions. Nothing of it outlives its connection.
 */
final class OutBox {

  /** Which commands replace each other. */
  record Slot(DeviceId device, int subtype) {}

  private static final int A_MILLION = 1_000_000;

  private final int maxRequests;
  private final ArrayDeque<ByteBuffer> requests = new ArrayDeque<>();
  private final Map<Slot, ByteBuffer> commands = new LinkedHashMap<>();
  private long replaced;
  private boolean woken;
  private boolean finishing;

  OutBox(int maxRequests) {
    this.maxRequests = maxRequests;
  }

  /** Adds a request; answers false if too many wait, or no more is taken. */
  synchronized boolean request(ByteBuffer frame) {
    if (finishing || requests.size() >= maxRequests) {
      return false;
    }
    requests.add(frame);
    wake();
    return true;
  }

  /** Adds a command in place of an older one; answers false if no more is taken. */
  synchronized boolean command(Slot slot, ByteBuffer frame) {
    if (finishing) {
      return false;
    }
    replaced += commands.put(slot, frame) == null ? 0 : 1;
    wake();
    return true;
  }

  /** Lets the taker look at the time again. */
  synchronized void wake() {
    woken = true;
    notifyAll();
  }

  /** Takes no more; what waits is still given out. */
  synchronized void finish() {
    finishing = true;
    wake();
  }

  /** Whether all was given out, and no more comes. */
  synchronized boolean isDone() {
    return finishing && requests.isEmpty() && commands.isEmpty();
  }

  /** How many commands were replaced by newer ones before they were sent. */
  synchronized long replaced() {
    return replaced;
  }

  /** Waits for something to send, until that time ({@link System#nanoTime}), or until woken. */
  synchronized Optional<ByteBuffer> take(long until) throws InterruptedException {
    while (requests.isEmpty() && commands.isEmpty() && !woken) {
      long millis = (until - System.nanoTime()) / A_MILLION;
      if (millis <= 0) {
        break;
      }
      wait(millis);
    }
    woken = false;
    return poll();
  }

  private Optional<ByteBuffer> poll() {
    if (!commands.isEmpty()) {
      Slot first = commands.keySet().iterator().next();
      return Optional.of(commands.remove(first));
    }
    return Optional.ofNullable(requests.poll());
  }
}
