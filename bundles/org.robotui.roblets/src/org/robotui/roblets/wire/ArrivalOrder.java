package org.robotui.roblets.wire;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Which datagrams are taken: those of a sender that are newer than the last one of the same name. What comes twice or
 * late is left out, and so is what an earlier run of the sender said; what is missing is counted. Of a sender that went
 * silent any run is taken, since its clock may have been set back. Safe for all threads.
 */
public final class ArrivalOrder {
  private static final int MOST_SENDERS = 256;
  private static final int MOST_NAMES = 128;
  private static final long FORGET_NANOS = Duration.ofSeconds(5).toNanos();

  private final Map<String, Books> senders = new HashMap<>();

  /** What is to be done with a datagram. */
  public enum Arrival {
    /** It is new. */
    TAKEN,
    /** It is new, and the first one of a run of its sender. */
    STARTED,
    /** It came already. */
    DOUBLED,
    /** A newer one of its name came before. */
    LATE,
    /** The sender was started again since then, or there are more senders than can be. */
    OLD_RUN;

    /**
     * Whether it is to be taken.
     *
     * @return false where it is doubled, late or old
     */
    public boolean isNew() {
      return this == TAKEN || this == STARTED;
    }
  }

  /**
   * How it went with one sender.
   *
   * @param received datagrams that came, each once
   * @param lost that did not come, or have not come yet
   * @param late that came after newer ones
   * @param doubled that came again
   * @param runs how often it was started, as far as it was heard
   */
  public record Tally(long received, long lost, long late, long doubled, int runs) {}

  private static final class Books {
    private long run;
    private long heardAt;
    private long first;
    private long highest;
    private long received;
    private long taken; // of this run
    private long lostBefore;
    private long late;
    private long doubled;
    private int runs;
    private final Map<String, Long> last = new HashMap<>();

    private void begin(BodyDatagram datagram) {
      lostBefore += lost();
      run = datagram.run();
      first = datagram.sequence();
      highest = first - 1;
      taken = 0;
      runs++;
      last.clear();
    }

    private long lost() {
      return runs == 0 ? 0 : Math.max(0, highest - first + 1 - taken);
    }

    private Arrival take(BodyDatagram datagram, String name, boolean started) {
      if (last.size() >= MOST_NAMES && !last.containsKey(name)) {
        return Arrival.OLD_RUN;
      }
      long before = last.getOrDefault(name, -1L);
      if (datagram.sequence() == before) {
        doubled++;
        return Arrival.DOUBLED;
      }
      received++;
      taken++;
      highest = Math.max(highest, datagram.sequence());
      if (datagram.sequence() < before) {
        late++;
        return Arrival.LATE;
      }
      last.put(name, datagram.sequence());
      return started ? Arrival.STARTED : Arrival.TAKEN;
    }
  }

  /** Nothing has come yet. */
  public ArrivalOrder() {
    // senders are known by what comes
  }

  /**
   * Judges a datagram.
   *
   * @param datagram as it came
   * @param nowNanos {@link System#nanoTime()}
   * @return what is to be done with it
   */
  public synchronized Arrival judge(BodyDatagram datagram, long nowNanos) {
    Books books = senders.get(datagram.from());
    if (books == null) {
      senders.values().removeIf(b -> senders.size() >= MOST_SENDERS && nowNanos - b.heardAt > FORGET_NANOS);
      if (senders.size() >= MOST_SENDERS) {
        return Arrival.OLD_RUN;
      }
      books = new Books();
      senders.put(datagram.from(), books);
    }
    boolean silent = nowNanos - books.heardAt > FORGET_NANOS;
    boolean started = books.runs == 0 || datagram.run() > books.run || datagram.run() < books.run && silent;
    if (datagram.run() < books.run && !started) {
      return Arrival.OLD_RUN;
    }
    if (started) {
      books.begin(datagram);
    }
    books.heardAt = nowNanos;
    String name = datagram.kind().word() + " " + datagram.body().map(body -> body.name()).orElse("");
    return books.take(datagram, name, started);
  }

  /**
   * How it went with a sender.
   *
   * @param sender its name
   * @return none where nothing came of it
   */
  public synchronized Optional<Tally> tally(String sender) {
    return Optional.ofNullable(senders.get(sender))
        .map(b -> new Tally(b.received, b.lostBefore + b.lost(), b.late, b.doubled, b.runs));
  }
}
