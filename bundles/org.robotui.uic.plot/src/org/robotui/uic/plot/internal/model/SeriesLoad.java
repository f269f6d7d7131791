package org.robotui.uic.plot.internal.model;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.replay.TimeRange;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.uic.plot.internal.signal.Pipeline;
import org.robotui.uic.plot.internal.trace.Series;

/** Fills traces from their recordings, each recording read once for all of them. Runs once, on a worker. */
final class SeriesLoad implements Runnable {
  private final List<WholeTrace> traces;
  private final boolean byStamp;
  private final Map<StreamHistory, Set<SourceId>> histories = new HashMap<>();
  private final long memory;
  private volatile double progress;

  /** Given also how many samples are kept of a field that waits for those of another recording. */
  SeriesLoad(List<WholeTrace> traces, boolean byStamp, long memory) {
    this.traces = List.copyOf(traces);
    this.byStamp = byStamp;
    this.memory = memory;
    traces.forEach(trace -> trace.places().forEach(
        (source, place) -> histories.computeIfAbsent(place.history(), h -> new HashSet<>()).add(source)));
  }

  /** From 0 to 1. */
  double progress() {
    return progress;
  }

  boolean isWanted() {
    return traces.stream().anyMatch(trace -> trace.isWanted() && !trace.isDone());
  }

  @Override
  public void run() {
    List<Join> joins = traces.stream().filter(trace -> !trace.isOfOne()).map(trace -> new Join(trace, memory)).toList();
    Map<StreamHistory, String> failures = new HashMap<>();
    int read = 0;
    for (Map.Entry<StreamHistory, Set<SourceId>> each : histories.entrySet()) {
      read(each.getKey(), each.getValue(), joins).ifPresent(reason -> failures.put(each.getKey(), reason));
      read++;
      progress = (double) read / histories.size();
    }
    joins.forEach(Join::run);
    traces.forEach(trace -> trace.places().values().stream().map(place -> failures.get(place.history()))
        .filter(Objects::nonNull).findFirst().ifPresentOrElse(trace::fail, trace::end));
  }

  /** Says why it could not be read to its end. */
  private Optional<String> read(StreamHistory history, Set<SourceId> sources, List<Join> joins) {
    Map<String, Feed> feeds = new HashMap<>();
    sources.forEach(source -> feeds.put(source.port(), feed(history, source, joins)));
    try {
      history.read(Set.copyOf(feeds.keySet()), history.span(), new Taker(feeds, history.span(), progress));
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of("the recording cannot be read: " + e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.of("reading was ended");
    }
  }

  private Feed feed(StreamHistory history, SourceId source, List<Join> joins) {
    List<Leaf> leaves = new ArrayList<>();
    List<WholeTrace> fed = traces.stream().filter(trace -> trace.places().containsKey(source)).toList();
    fed.stream().filter(WholeTrace::isOfOne).flatMap(trace -> trace.leaves().stream())
        .filter(leaf -> leaf.field().source().equals(source)).forEach(leaves::add);
    joins.forEach(join -> join.collectors(source).forEach(leaves::add));
    long offset = fed.stream().map(trace -> trace.places().get(source).offset()).findFirst().orElse(0L);
    return new Feed(new RecordedClock(byStamp, offset), leaves, fed);
  }

  /** What the values of one source go to. */
  private static final class Feed {
    private final RecordedClock clock;
    private final List<Leaf> leaves;
    private final List<WholeTrace> traces;
    private long sequence;

    Feed(RecordedClock clock, List<Leaf> leaves, List<WholeTrace> traces) {
      this.clock = clock;
      this.leaves = leaves;
      this.traces = traces;
    }

    void take(RecordedValue value) {
      long time = clock.timeOf(value);
      DynamicRecord data = DataRecord.of(value.value());
      Supplier<DynamicRecord> own = () -> value.raw().flatMap(RawMessage::record).orElse(data);
      for (Leaf leaf : leaves) {
        leaf.take(sequence, time, data, own);
      }
      sequence++;
    }
  }

  private final class Taker implements HistoryTaker {
    private final Map<String, Feed> feeds;
    private final TimeRange range;
    private final double from;

    Taker(Map<String, Feed> feeds, TimeRange range, double from) {
      this.feeds = feeds;
      this.range = range;
      this.from = from;
    }

    @Override
    public void take(RecordedValue value) {
      feeds.get(value.port()).take(value);
    }

    @Override
    public void unreadable(String port, String reason) {
      feeds.get(port).traces.forEach(trace -> trace.refuse(reason));
    }

    @Override
    public boolean reached(long time) {
      double share = Math.clamp((double) (time - range.start()) / Math.max(1, range.length()), 0, 1);
      progress = from + share / histories.size();
      traces.forEach(WholeTrace::tell);
      return isWanted();
    }
  }

  /** A trace of several recordings: its fields are read first, and computed together then, in the order of time. */
  private static final class Join implements Runnable {
    private final WholeTrace trace;
    private final List<Series> fields = new ArrayList<>();
    private final List<Leaf> collectors = new ArrayList<>();

    Join(WholeTrace trace, long memory) {
      this.trace = trace;
      trace.leaves().forEach(leaf -> {
        Series field = new Series(memory);
        fields.add(field);
        collectors.add(new Leaf(new Pipeline.Input(leaf.field(), field::add), leaf.gap()));
      });
    }

    List<Leaf> collectors(SourceId source) {
      return collectors.stream().filter(leaf -> leaf.field().source().equals(source)).toList();
    }

    @Override
    public void run() {
      FieldMerge.into(trace.leaves(), fields.stream().map(Series::samples).toList());
    }
  }
}
