package org.robotui.rfic.recording.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.port.Input;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.data.Data;
import org.robotui.rfic.recording.internal.time.SearchableHistory;
import org.robotui.rfic.recording.internal.time.SharedTimeline;

/** A recording of what a test tells, by seconds. */
public final class ToldHistory implements SearchableHistory {
  private static final long SECOND = 1_000_000_000L;

  private final List<RecordedValue> values = new ArrayList<>();
  private final List<Input.Candidate> candidates = new ArrayList<>();

  /** A value without the message that it came in. */
  public ToldHistory says(String port, double seconds, Data value) {
    return says(port, seconds, value, Optional.empty());
  }

  /** A value, and the message that it came in. */
  public ToldHistory says(String port, double seconds, Data value, Optional<RawMessage> raw) {
    Input.Candidate candidate =
        new Input.Candidate(new SourceId("recording", port), value.getClass().getSimpleName());
    if (!candidates.contains(candidate)) {
      candidates.add(candidate);
    }
    values.add(new RecordedValue(port, value, nanos(seconds), Optional.empty(), raw));
    return this;
  }

  public static long nanos(double seconds) {
    return Math.round(seconds * SECOND);
  }

  @Override
  public List<Input.Candidate> candidates() {
    return candidates;
  }

  @Override
  public TimeRange span() {
    return new TimeRange(values.getFirst().time(), values.getLast().time());
  }

  @Override
  public Timeline timeline() {
    return new SharedTimeline();
  }

  @Override
  public long offset() {
    return 0;
  }

  @Override
  public long count(String port) {
    return values.stream().filter(each -> each.port().equals(port)).count();
  }

  @Override
  public void read(Set<String> ports, TimeRange range, HistoryTaker taker) {
    values.stream().filter(each -> ports.contains(each.port()))
        .filter(each -> each.time() >= range.start() && each.time() <= range.end()).forEach(taker::take);
  }
}
