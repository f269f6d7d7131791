package org.robotui.roblets.internal;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.roblets.tree.BodyElement;

/** What came for a roblet and was not taken yet: the newest of each sender and name. Safe for all threads. */
public final class RobletInbox {
  private static final int MOST = 128;

  private final Map<String, Letter> letters = new LinkedHashMap<>();
  private boolean closed;

  /** Something that came. */
  public record Letter(String from, BodyElement message) {}

  public synchronized void put(String from, BodyElement message) {
    String key = from + "/" + message.name();
    if (letters.size() < MOST || letters.containsKey(key)) {
      letters.put(key, new Letter(from, message));
      notifyAll();
    }
  }

  /** The oldest, where one comes before a time of {@link System#nanoTime()}. */
  public synchronized Optional<Letter> take(long untilNanos) throws InterruptedException {
    long left = untilNanos - System.nanoTime();
    while (letters.isEmpty() && !closed && left > 0) {
      wait(left / 1_000_000, (int) (left % 1_000_000));
      left = untilNanos - System.nanoTime();
    }
    if (letters.isEmpty() || closed) {
      return Optional.empty();
    }
    return Optional.of(letters.remove(letters.keySet().iterator().next()));
  }

  public synchronized void clear() {
    letters.clear();
  }

  /** Nobody waits any more. */
  public synchronized void close() {
    closed = true;
    notifyAll();
  }
}
