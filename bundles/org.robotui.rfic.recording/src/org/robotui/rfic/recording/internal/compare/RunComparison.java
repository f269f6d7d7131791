package org.robotui.rfic.recording.internal.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.LongFunction;
import java.util.stream.Stream;
import org.robotui.condition.TimedCondition;
import org.robotui.data.record.FieldPath;
import org.robotui.rfic.recording.internal.compare.CompareWish.Pairing;
import org.robotui.rfic.recording.internal.find.ConditionScan;
import org.robotui.rfic.recording.internal.find.SourceWords;

/**
 * Compares two recordings. Absolute and relative errors of poses are those of evo: M. Grupp, evo: Python package for
 * the evaluation of odometry and SLAM, 2017. For one thread.
 */
public final class RunComparison {
  private final ComparedFile one;
  private final ComparedFile other;
  private final CompareWish wish;
  private final List<String> problems = new ArrayList<>();

  /**
   * Prepares it.
   *
   * @param one the recording with which the other is compared
   * @param other the other one
   * @param wish how
   */
  public RunComparison(ComparedFile one, ComparedFile other, CompareWish wish) {
    this.one = one;
    this.other = other;
    this.wish = wish;
  }

  /**
   * Reads both and compares them.
   *
   * @return what it came to
   * @throws CompareException where they cannot be compared so
   * @throws IOException where a file cannot be read any more
   * @throws InterruptedException where the thread was interrupted
   */
  public ComparedRuns run() throws CompareException, IOException, InterruptedException {
    Optional<FieldPath> field = wish.topic().field();
    return field.isPresent() ? series(field.get()) : ways();
  }

  private ComparedRuns ways() throws CompareException, IOException, InterruptedException {
    RecordedWay first = way(one, wish.topic().first());
    RecordedWay second = way(other, wish.topic().second());
    long shift = 0;
    PosePairs pairs;
    if (wish.pairing() instanceof Pairing.Gone) {
      pairs = PosePairs.mapped(first, second, mapping(first, second));
    } else {
      shift = shift(first.time(0), second.time(0));
      pairs = PosePairs.nearest(first, second, shift, wish.mostApart());
    }
    return new ComparedRuns(pairs.times().size(), first.size(), second.size(), shift,
        pairs.aligned(wish.fit()).errors(wish.step()).stream().map(each -> each.over(first::goneAt)).toList(),
        problems);
  }

  private RecordedWay way(ComparedFile file, String topic) throws CompareException, IOException, InterruptedException {
    return new StreamReading(file, topic, problems).way();
  }

  private ComparedRuns series(FieldPath field) throws CompareException, IOException, InterruptedException {
    NumberSeries first = new StreamReading(one, wish.topic().first(), problems).series(field);
    NumberSeries second = new StreamReading(other, wish.topic().second(), problems).series(field);
    long shift = wish.pairing() instanceof Pairing.Gone ? 0 : shift(first.times()[0], second.times()[0]);
    LongFunction<OptionalLong> mapping = wish.pairing() instanceof Pairing.Gone(var topic)
        ? mapping(topic.orElseThrow(() -> new CompareException("numbers are compared by the way gone where --way"
            + " names the topic that says where the robot was")))
        : time -> OptionalLong.of(time - shift);
    List<Long> times = new ArrayList<>();
    List<Double> differences = new ArrayList<>();
    for (int i = 0; i < first.times().length; i++) {
      OptionalLong there = mapping.apply(first.times()[i]);
      Optional<Double> value = there.isPresent() ? second.at(there.getAsLong()) : Optional.empty();
      if (value.isPresent()) {
        times.add(first.times()[i]);
        differences.add(value.get() - first.values()[i]);
      }
    }
    if (times.isEmpty()) {
      throw new CompareException("no values of both belong together: their times do not overlap; align them by their"
          + " starts, or with --offset");
    }
    return new ComparedRuns(times.size(), first.times().length, second.times().length, shift,
        differences(times, differences), problems);
  }

  private List<ErrorSeries> differences(List<Long> times, List<Double> values) {
    long[] at = times.stream().mapToLong(Long::longValue).toArray();
    double[] difference = values.stream().mapToDouble(Double::doubleValue).toArray();
    double[] size = values.stream().mapToDouble(Math::abs).toArray();
    return List.of(ErrorSeries.of("difference", "", at, difference),
        ErrorSeries.of("absolute difference", "", at, size));
  }

  private LongFunction<OptionalLong> mapping(ComparedTopic topic)
      throws CompareException, IOException, InterruptedException {
    return mapping(way(one, topic.first()), way(other, topic.second()));
  }

  private static LongFunction<OptionalLong> mapping(RecordedWay first, RecordedWay second) {
    return time -> second.timeOf(first.goneAt(time));
  }

  /** What is added to times of the second recording. */
  private long shift(long first, long second) throws CompareException, IOException, InterruptedException {
    long paired = switch (wish.pairing()) {
      case Pairing.Clock clock -> other.offset() - one.offset();
      case Pairing.Start start -> first - second;
      case Pairing.Event event -> event(one, event.condition()) - event(other, event.condition());
      case Pairing.Gone gone -> 0;
    };
    return paired + wish.offset();
  }

  /** When a condition holds for the first time. */
  private static long event(ComparedFile file, String condition)
      throws CompareException, IOException, InterruptedException {
    TimedCondition timed = TimedCondition.parse(condition, 0);
    if (ConditionScan.sources(timed, file.history()).isEmpty()) {
      throw new CompareException(file.name() + ": " + SourceWords.nothing(Stream.of(file.history())));
    }
    long[] first = {Long.MAX_VALUE};
    ConditionScan.run(timed, file.history(), file.range(),
        span -> first[0] = Math.min(first[0], span.range().start()), time -> first[0] == Long.MAX_VALUE);
    if (first[0] == Long.MAX_VALUE) {
      throw new CompareException(file.name() + ": it was never so that " + condition);
    }
    return first[0];
  }
}
