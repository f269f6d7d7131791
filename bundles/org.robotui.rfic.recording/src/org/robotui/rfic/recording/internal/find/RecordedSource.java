package org.robotui.rfic.recording.internal.find;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.RawMessage;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.time.Freshness;
import org.robotui.api.time.RateMeter;
import org.robotui.condition.Signals.Reading;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.Keyed;

/** What one stream of a recording has said until a time, as a robot would have. For one thread. */
final class RecordedSource {
  private static final double SECONDS = 1e-9;

  private final Input.Candidate candidate;
  private final RateMeter rate;
  private Optional<Envelope<Data>> newest = Optional.empty();
  private boolean kept;

  /** Has said nothing yet; its rate is counted from a time on. */
  RecordedSource(Input.Candidate candidate, long start) {
    this.candidate = candidate;
    this.rate = new RateMeter(start);
  }

  Input.Candidate candidate() {
    return candidate;
  }

  void take(RecordedValue value) {
    rate.mark(value.time());
    kept = value.raw().map(RawMessage::origin).filter(origin -> origin.kept()).isPresent();
    Data merged = newest.map(before -> merge(value.value(), before.value())).orElse(value.value());
    newest = Optional.of(new Envelope<>(merged, candidate.id(), rate.count() - 1, value.stamp(), value.time(),
        merged == value.value() ? value.raw() : Optional.empty()));
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // keyed values of one class merge with each other by contract
  private static Data merge(Data value, Data before) {
    if (!(value instanceof Keyed keyed) || value.getClass() != before.getClass()) {
      return value;
    }
    Keyed all = (Keyed) keyed.over((Keyed) before);
    return all.keys() <= all.most() ? all : (Data) all.last(all.most());
  }

  Reading reading(long now) {
    if (newest.isEmpty()) {
      return new Reading(candidate.id().port(), new InputState.Waiting("no data yet"), List.of(),
          OptionalDouble.empty());
    }
    Envelope<Data> last = newest.get();
    OptionalDouble delay = last.stamp().stream()
        .mapToDouble(stamp -> (last.receivedNanos() - stamp.nanos()) * SECONDS).findFirst();
    return new Reading(candidate.id().port(), state(last, now), List.of(last), delay);
  }

  private InputState state(Envelope<Data> last, long now) {
    double age = (now - last.receivedNanos()) * SECONDS;
    boolean stale = Freshness.isStale(DataType.of(last.value().getClass()), kept, age, rate.typicalPeriodSeconds());
    return stale ? new InputState.Stale(age, "no new value")
        : new InputState.Live(rate.rateHz(now), age);
  }
}
