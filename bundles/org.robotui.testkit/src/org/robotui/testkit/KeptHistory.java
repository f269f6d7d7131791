package org.robotui.testkit;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.api.port.RawMessage;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.Stamp;

/** A recording in memory. */
public final class KeptHistory implements StreamHistory {
  /** In nanoseconds. */
  public static final long SECOND = 1_000_000_000L;
  /** When the recording begins, in nanoseconds since 1970. */
  public static final long BEGIN = 1_700_000_000L * SECOND;

  private final Timeline timeline;
  private final List<RecordedValue> values = new ArrayList<>();
  private Optional<String> failure = Optional.empty();
  private int tellEvery = 10;
  private volatile long offset;
  private volatile int readings;
  private volatile int given;

  /** Without values. */
  public KeptHistory(Timeline timeline) {
    this.timeline = timeline;
  }

  /** Adds a value with a stamp of the time at which it was recorded, in seconds. */
  public KeptHistory add(String port, double seconds, Data value) {
    long time = BEGIN + Math.round(seconds * SECOND);
    return add(port, time, OptionalLong.of(time), value);
  }

  /** Adds a value with any stamp, both in nanoseconds since 1970. */
  public KeptHistory add(String port, long time, OptionalLong stamp, Data value) {
    return add(port, time, stamp, value, Optional.empty());
  }

  /** The same, with the message that it came as. */
  public KeptHistory add(String port, long time, OptionalLong stamp, Data value, Optional<RawMessage> raw) {
    Optional<Stamp> stamped =
        stamp.isPresent() ? Optional.of(new Stamp(stamp.getAsLong(), ClockKind.SIMULATED)) : Optional.empty();
    values.add(new RecordedValue(port, value, time, stamped, raw));
    return this;
  }

  /** Has readings fail behind the last value. */
  public void fail(String reason) {
    failure = Optional.of(reason);
  }

  /** Tells how far it is at each so many values. */
  public void tellEvery(int count) {
    tellEvery = count;
  }

  /** Sets by how much the user has moved it, in nanoseconds. */
  public void offset(long nanos) {
    offset = nanos;
  }

  /** How often it was read. */
  public int readings() {
    return readings;
  }

  /** How many values were given by all readings. */
  public int given() {
    return given;
  }

  @Override
  public Timeline timeline() {
    return timeline;
  }

  @Override
  public TimeRange span() {
    return new TimeRange(values.getFirst().time(), values.getLast().time());
  }

  @Override
  public long offset() {
    return offset;
  }

  @Override
  public long count(String port) {
    return values.stream().filter(each -> each.port().equals(port)).count();
  }

  @Override
  public void read(Set<String> ports, TimeRange range, HistoryTaker taker) throws IOException {
    readings++;
    int count = 0;
    for (RecordedValue value : values) {
      if (count++ % tellEvery == 0 && !taker.reached(value.time())) {
        return;
      }
      if (ports.contains(value.port()) && range.start() <= value.time() && value.time() <= range.end()) {
        given++;
        taker.take(value);
      }
    }
    if (failure.isPresent()) {
      throw new IOException(failure.get());
    }
    taker.reached(range.end());
  }
}
