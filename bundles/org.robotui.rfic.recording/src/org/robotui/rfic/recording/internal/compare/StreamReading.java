package org.robotui.rfic.recording.internal.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.ToLongFunction;
import java.util.stream.Collectors;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.TimeRange;
import org.robotui.condition.SourceName;
import org.robotui.data.geometry.Pose;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.geometry.RigidTransform;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/** Reads what is compared of one recording. */
final class StreamReading {
  private static final int MOST = 2_000_000;

  private record Place(long time, RigidTransform pose) {}

  private record Sample(long time, double value) {}

  private final SearchableHistory history;
  private final String file;
  private final TimeRange range;
  private final Input.Candidate stream;
  private final List<String> problems;

  StreamReading(ComparedFile run, String name, List<String> problems) throws CompareException {
    this.history = run.history();
    this.file = run.name();
    this.range = run.range();
    this.problems = problems;
    SourceName wanted = new SourceName(name);
    this.stream = history.candidates().stream().filter(each -> wanted.fits(each.id())).findFirst()
        .orElseThrow(() -> new CompareException(file + " has no topic '" + name + "'; it has " + names()));
  }

  private String names() {
    return history.candidates().stream().map(each -> each.id().port()).sorted().collect(Collectors.joining(", "));
  }

  /** Where the robot was. */
  RecordedWay way() throws IOException, InterruptedException, CompareException {
    List<Place> places = new ArrayList<>();
    Set<String> others = new HashSet<>();
    read(value -> {
      if (value.value() instanceof Pose pose) {
        places.add(new Place(value.placed(), pose.pose()));
      } else {
        others.add(value.value().getClass().getSimpleName());
      }
      return places.size();
    });
    if (places.isEmpty()) {
      throw new CompareException(others.isEmpty() ? file + ": " + stream.id().port() + " has no value in that time"
          : file + ": " + stream.id().port() + " does not say where something is; name one of its numbers, such as \""
              + stream.id().port() + " FIELD\"");
    }
    List<Place> sorted = rising(places, Place::time);
    return new RecordedWay(sorted.stream().mapToLong(Place::time).toArray(),
        sorted.stream().map(Place::pose).toList());
  }

  /** A number of it. */
  NumberSeries series(FieldPath field) throws IOException, InterruptedException, CompareException {
    List<Sample> samples = new ArrayList<>();
    String[] without = {""};
    read(value -> {
      OptionalDouble number = number(value, field);
      if (number.isPresent()) {
        samples.add(new Sample(value.placed(), number.getAsDouble()));
      } else {
        without[0] = String.join(", ", envelope(value).record().fields());
      }
      return samples.size();
    });
    if (samples.isEmpty()) {
      throw new CompareException(file + ": " + stream.id().port()
          + (without[0].isEmpty() ? " has no value in that time"
              : " has no number '" + field + "'; it has " + without[0]));
    }
    List<Sample> sorted = rising(samples, Sample::time);
    return new NumberSeries(sorted.stream().mapToLong(Sample::time).toArray(),
        sorted.stream().mapToDouble(Sample::value).toArray());
  }

  private OptionalDouble number(RecordedValue value, FieldPath field) {
    Optional<FieldValue> found =
        DataRecord.of(value.value()).at(field).or(() -> envelope(value).record().at(field));
    return switch (found.orElse(new FieldValue.Text(""))) {
      case FieldValue.Num number when Double.isFinite(number.value()) -> OptionalDouble.of(number.value());
      case FieldValue.Flag flag -> OptionalDouble.of(flag.value() ? 1 : 0);
      case FieldValue.Time time -> OptionalDouble.of(time.nanos() * 1e-9);
      default -> OptionalDouble.empty();
    };
  }

  private Envelope<?> envelope(RecordedValue value) {
    return new Envelope<>(value.value(), stream.id(), 0, value.stamp(), value.time(), value.raw());
  }

  /** Of several of one time the first one. */
  private static <V> List<V> rising(List<V> values, ToLongFunction<V> time) {
    List<V> sorted = values.stream().sorted(Comparator.comparingLong(time)).toList();
    List<V> rising = new ArrayList<>();
    for (V each : sorted) {
      if (rising.isEmpty() || time.applyAsLong(each) > time.applyAsLong(rising.getLast())) {
        rising.add(each);
      }
    }
    return rising;
  }

  /** Takes a value, and says how many are kept. */
  private interface Keeping {
    int keep(RecordedValue value);
  }

  private void read(Keeping keeping) throws IOException, InterruptedException, CompareException {
    int[] kept = {0};
    long[] unreadable = {0};
    String[] first = {""};
    history.read(Set.of(stream.id().port()), range, new HistoryTaker() {
      @Override
      public void take(RecordedValue value) {
        kept[0] = keeping.keep(value);
      }

      @Override
      public void unreadable(String port, String reason) {
        first[0] = unreadable[0]++ == 0 ? reason : first[0];
      }

      @Override
      public boolean reached(long time) {
        return kept[0] <= MOST;
      }
    });
    if (kept[0] > MOST) {
      throw new CompareException(file + ": " + stream.id().port() + " has more than " + MOST
          + " values, more than are compared at once: compare a part, by --from and --to");
    }
    if (unreadable[0] > 0) {
      problems.add(file + ": " + unreadable[0] + " messages of " + stream.id().port()
          + " could not be read, the first: " + first[0]);
    }
  }
}
