package org.robotui.bridge.internal.carry;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;

/** Values on their way, until they may pass: as many as configured, and not faster. One thread. */
final class WaitingValues {
  private static final double NANOS = 1e9;

  private final Deque<Envelope<?>> waiting = new ArrayDeque<>();
  private final boolean newest;
  private final int most;
  private final long period;
  private long due = Long.MIN_VALUE;
  private long thinned;
  private long dropped;

  /** As configured; without a word, a rate leaves out what is older, and nothing else is. */
  WaitingValues(Settings settings) {
    newest = settings.has("keep") ? settings.text("keep").equals(BridgeWords.NEWEST) : settings.has("rate");
    most = (int) settings.integer("queue");
    period = settings.has("rate") ? (long) (NANOS / settings.number("rate")) : 0;
  }

  void add(Envelope<?> envelope) {
    if (newest) {
      thinned += waiting.size();
      waiting.clear();
    } else if (waiting.size() >= most) {
      waiting.removeFirst();
      dropped++;
    }
    waiting.addLast(envelope);
  }

  /** What may pass now; it goes on waiting until {@link #passed}. */
  Optional<Envelope<?>> next(long now) {
    boolean early = period > 0 && due != Long.MIN_VALUE && now - due < 0;
    return early ? Optional.empty() : Optional.ofNullable(waiting.peekFirst());
  }

  /** The next one has passed, or never will. */
  void passed(long now) {
    waiting.pollFirst();
    due = due == Long.MIN_VALUE ? now + period : Math.max(due + period, now + period / 2);
  }

  boolean isEmpty() {
    return waiting.isEmpty();
  }

  long thinned() {
    return thinned;
  }

  long dropped() {
    return dropped;
  }
}
