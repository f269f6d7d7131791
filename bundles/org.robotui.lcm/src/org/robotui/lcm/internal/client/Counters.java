package org.robotui.lcm.internal.client;

import java.util.concurrent.atomic.LongAdder;
import org.robotui.lcm.LcmStatistics;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** What is counted of one connection. */
public final class Counters {

  private static final Logger LOG = LoggerFactory.getLogger(Counters.class);

  private final LongAdder received = new LongAdder();
  private final LongAdder receivedBytes = new LongAdder();
  private final LongAdder published = new LongAdder();
  private final LongAdder publishedBytes = new LongAdder();
  private final LongAdder lost = new LongAdder();
  private final LongAdder incomplete = new LongAdder();
  private final LongAdder damaged = new LongAdder();
  private final LongAdder dropped = new LongAdder();
  private final LongAdder listenerErrors = new LongAdder();
  private final LogThrottle damages = new LogThrottle();
  private volatile int receiveBufferWanted;
  private volatile int receiveBuffer;
  private volatile String lastDamage = "";

  public void received(int bytes) {
    received.increment();
    receivedBytes.add(bytes);
  }

  public void published(int bytes) {
    published.increment();
    publishedBytes.add(bytes);
  }

  /** Messages that are missing; negative if some came late. */
  public void lost(long messages) {
    lost.add(messages);
  }

  public void incomplete() {
    incomplete.increment();
  }

  /** Something that is no message, or none that is accepted. */
  public void damaged(String reason) {
    damaged.increment();
    lastDamage = PeerText.brief(reason);
    if (damages.admit()) {
      LOG.warn("LCM: {} ({} so far)", lastDamage, damages.count());
    }
  }

  void dropped() {
    dropped.increment();
  }

  void listenerError() {
    listenerErrors.increment();
  }

  public void receiveBuffer(int wanted, int granted) {
    receiveBufferWanted = wanted;
    receiveBuffer = granted;
  }

  LcmStatistics figures() {
    return new LcmStatistics(received.sum(), receivedBytes.sum(), published.sum(), publishedBytes.sum(), lost.sum(),
        incomplete.sum(),
        damaged.sum(), dropped.sum(), listenerErrors.sum(), receiveBufferWanted, receiveBuffer, lastDamage);
  }
}
