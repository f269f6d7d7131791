package org.robotui.rfic.xbot.internal;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.data.record.DynamicRecord;
import org.robotui.xbot.Board;
import org.robotui.xbot.CycleReader;
import org.robotui.xbot.RtClient;
import org.robotui.xbot.StateFrame;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Every cycle of a control as a stream, while somebody wants that, on a thread of its own: whatever else keeps a
 * session waiting costs no cycle. The control is not asked for anything; its memory is looked into.
 */
final class CycleFeed implements AutoCloseable {
  private static final Duration PAUSE = Duration.ofMillis(5);
  /** So many at a time, half of what core keeps for those who take them, so that they come after. */
  private static final int MOST_AT_ONCE = 512;
  private static final Logger LOG = LoggerFactory.getLogger(CycleFeed.class);

  private final RtClient client;
  private final CycleMessages messages = new CycleMessages(XbotPorts.CYCLES.name());
  private final Publication<DynamicRecord> publication;
  private final Thread worker;
  private boolean wanted; // guarded by this

  CycleFeed(RficContext context, RtClient client) {
    this.client = client;
    this.publication = context.offers().stream(XbotPorts.CYCLES, this::want);
    this.worker = context.threads().newThread(this::work);
    worker.start();
  }

  private synchronized void want(boolean now) {
    wanted = now;
    notifyAll();
  }

  private synchronized boolean isWanted() {
    return wanted;
  }

  private synchronized void await() throws InterruptedException {
    while (!wanted) {
      wait();
    }
  }

  private void work() {
    try {
      while (true) {
        await();
        follow();
      }
    } catch (InterruptedException e) {
      LOG.debug("nobody follows the cycles any more");
    }
  }

  /** Times of the day by one look at the clock: who sets it meanwhile does not reorder cycles. */
  private void follow() throws InterruptedException {
    Instant now = Instant.now();
    long toTimeOfDay = now.getEpochSecond() * 1_000_000_000L + now.getNano() - System.nanoTime();
    CycleReader reader = client.cycles();
    while (isWanted()) {
      client.board().ifPresent(board -> publish(board, reader, toTimeOfDay));
      Thread.sleep(PAUSE);
    }
  }

  private void publish(Board board, CycleReader reader, long toTimeOfDay) {
    for (int i = 0; i < MOST_AT_ONCE; i++) {
      long before = reader.lost();
      Optional<StateFrame> next = reader.next();
      if (next.isEmpty()) {
        return;
      }
      if (reader.lost() > before) {
        publication.lost(reader.lost() - before,
            "cycles were written over before they could be read: the machine is too busy");
      }
      publish(board, next.get(), toTimeOfDay, reader.lost());
    }
  }

  private void publish(Board board, StateFrame state, long toTimeOfDay, long lost) {
    long stamp = state.sensedNanos() + toTimeOfDay;
    RawMessage message = messages.of(board, state, stamp, lost);
    publication.publish(new CycleRecord(message.schema(), message::record),
        Optional.of(new Stamp(stamp, ClockKind.WALL)), state.sensedNanos(), Optional.of(message));
  }

  @Override
  public void close() {
    worker.interrupt();
    publication.close();
  }
}
