package org.robotui.rfic.lcm.internal.session;

import java.util.Set;
import java.util.TreeSet;
import org.robotui.lcm.LcmMessage;

/** What was heard on one channel. Safe for all threads. */
final class Tally {
  private static final int MOST_SENDERS = 32;
  private static final double SECOND = 1e9;
  /** How much the newest pause between two messages counts. */
  private static final double SHARE = 0.1;

  private final Set<String> senders = new TreeSet<>();
  private long messages;
  private long bytes;
  private int size;
  private long last;
  private double period;

  /**
   * What was heard so far.
   *
   * @param messages how many
   * @param bytes all together
   * @param size of the last one
   * @param hertz how many come in a second, 0 where that is not known
   * @param silentSeconds since the last one
   * @param senders who sent them
   */
  record Heard(long messages, long bytes, int size, double hertz, double silentSeconds, Set<String> senders) {}

  synchronized void heard(LcmMessage message) {
    if (messages > 0) {
      double pause = (message.received() - last) / SECOND;
      period = messages == 1 ? pause : period + SHARE * (pause - period);
    }
    messages++;
    size = message.data().remaining();
    bytes += size;
    last = message.received();
    if (senders.size() < MOST_SENDERS) {
      senders.add(message.sender());
    }
  }

  synchronized Heard heard() {
    double silent = messages == 0 ? Double.POSITIVE_INFINITY : (System.nanoTime() - last) / SECOND;
    double pause = Math.max(period, silent > period * 2 ? silent : 0);
    return new Heard(messages, bytes, size, pause > 0 ? 1 / pause : 0, silent, Set.copyOf(senders));
  }
}
