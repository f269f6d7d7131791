package org.robotui.uic.topics.internal.model;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.api.port.RawMessage;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.replay.TimeRange;

/**
 * The messages of a recorded topic around a time. Read once, on a worker; immutable.
 *
 * @param low where the position may be and no row before it is missing, time of the recording
 * @param high the same behind
 * @param rows by time
 */
record MessageRows(long low, long high, List<TimedMessage> rows) {
  /** How many are listed before the position, and behind it. */
  static final int EACH = 200;
  private static final int CLOSE = 50;
  private static final long SHORTEST_NANOS = 100_000_000L;
  private static final int WIDER = 4;

  static final MessageRows NONE = new MessageRows(Long.MAX_VALUE, Long.MIN_VALUE, List.of());

  boolean holds(long position) {
    return position >= low && position <= high;
  }

  /** The last message until a time. */
  Optional<TimedMessage> at(long time) {
    return rows.stream().takeWhile(row -> row.time() <= time).reduce((a, b) -> b);
  }

  /** Reads as much of the recording as is needed, more where messages are rare around that time. */
  static MessageRows read(StreamHistory history, String port, long at) throws IOException, InterruptedException {
    TimeRange span = history.span();
    long position = span.nearest(at);
    long half = Math.max(SHORTEST_NANOS, span.length() / Math.max(1, history.count(port)) * EACH);
    while (true) {
      TimeRange range = new TimeRange(Math.max(span.start(), subtract(position, half)),
          Math.min(span.end(), add(position, half)));
      Taken taken = new Taken(position);
      history.read(Set.of(port), range, taken);
      boolean first = range.start() == span.start();
      boolean last = range.end() == span.end();
      if ((first || taken.before.size() > EACH) && (last || taken.behind.size() >= EACH)) {
        return taken.rows(first && !taken.lost, last && taken.behind.size() < EACH);
      }
      half = half > Long.MAX_VALUE / WIDER ? Long.MAX_VALUE : half * WIDER;
    }
  }

  private static long add(long time, long more) {
    return time > Long.MAX_VALUE - more ? Long.MAX_VALUE : time + more;
  }

  private static long subtract(long time, long less) {
    return time < Long.MIN_VALUE + less ? Long.MIN_VALUE : time - less;
  }

  private static final class Taken implements HistoryTaker {
    private final long position;
    /** One more than is shown: the gap of the first one is told by it. */
    private final Deque<TimedMessage> before = new ArrayDeque<>();
    private final List<TimedMessage> behind = new ArrayList<>();
    private boolean lost;
    private OptionalLong last = OptionalLong.empty();
    private int place;

    Taken(long position) {
      this.position = position;
    }

    @Override
    public void take(RecordedValue value) {
      place = last.isPresent() && last.getAsLong() == value.time() ? place + 1 : 0;
      OptionalLong gap = last.isPresent() ? OptionalLong.of(value.time() - last.getAsLong()) : OptionalLong.empty();
      last = OptionalLong.of(value.time());
      OptionalInt size = value.raw().map(RawMessage::bytes).map(bytes -> OptionalInt.of(bytes.size()))
          .orElseGet(OptionalInt::empty);
      add(new TimedMessage(value.time(), place, gap, size));
    }

    private void add(TimedMessage message) {
      if (message.time() > position) {
        if (behind.size() < EACH) {
          behind.add(message);
        }
        return;
      }
      before.addLast(message);
      if (before.size() > EACH + 1) {
        before.removeFirst();
        lost = true;
      }
    }

    @Override
    public boolean reached(long time) {
      return behind.size() < EACH;
    }

    private MessageRows rows(boolean first, boolean last) {
      List<TimedMessage> all = new ArrayList<>(before);
      if (!first && !all.isEmpty()) {
        all.removeFirst();
      }
      all.addAll(behind);
      long low = first || all.size() <= CLOSE ? Long.MIN_VALUE : Math.min(position, all.get(CLOSE).time());
      long high = last || all.size() <= CLOSE ? Long.MAX_VALUE
          : Math.max(position, all.get(all.size() - CLOSE).time());
      return new MessageRows(low, high, List.copyOf(all));
    }
  }
}
