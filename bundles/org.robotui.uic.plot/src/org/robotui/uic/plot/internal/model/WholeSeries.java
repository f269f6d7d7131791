package org.robotui.uic.plot.internal.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.TimelineState;
import org.robotui.data.Data;
import org.robotui.uic.plot.internal.signal.Expr;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * The signals that are of recordings alone: read whole when they are first wanted, and again where a recording is moved
 * on the timeline or opened anew. Worker only; reading goes on in the background.
 */
public final class WholeSeries {
  /** How values are placed and kept. */
  record Rules(boolean byStamp, double gap, long memory) {}

  /** With what lies over them. */
  private static final int SAMPLE_BYTES = 20;
  private static final int SHARE_OF_MEMORY = 8;

  private final Input<?> input;
  private final Executor background;
  private final long most;
  private final Map<Expr, WholeTrace> traces = new LinkedHashMap<>();
  private List<SeriesLoad> loads = List.of();
  private Optional<Rules> rules = Optional.empty();

  /** An eighth of what Java may take is for the traces of a plot. */
  public WholeSeries(Input<Data> input, Executor background) {
    this(input, background, Runtime.getRuntime().maxMemory() / SHARE_OF_MEMORY / SAMPLE_BYTES);
  }

  WholeSeries(Input<Data> input, Executor background, long most) {
    this.input = input;
    this.background = background;
    this.most = most;
  }

  /** Has what is wanted read, as far as it is of recordings. */
  void follow(Set<Expr> wanted, Rules now) {
    if (!rules.equals(Optional.of(now))) {
      drop(Set.of());
      rules = Optional.of(now);
    }
    Map<Expr, Map<SourceId, WholeTrace.Place>> recorded = recorded(wanted);
    drop(recorded.keySet());
    traces.values().stream().filter(trace -> !trace.places().equals(recorded.get(trace.expr()))).toList()
        .forEach(this::drop);
    loads = loads.stream().filter(SeriesLoad::isWanted).toList();
    List<WholeTrace> fresh = new ArrayList<>();
    long room =
        Math.max(now.memory(), most / Math.max(1, recorded.keySet().stream().mapToInt(WholeSeries::kept).sum()));
    recorded.forEach((expr, places) -> {
      if (!traces.containsKey(expr)) {
        WholeTrace made = new WholeTrace(expr, places, now.gap(), room, expected(expr, places));
        traces.put(expr, made);
        fresh.add(made);
      }
    });
    if (!fresh.isEmpty()) {
      load(new SeriesLoad(fresh, now.byStamp(), room));
    }
  }

  /** How many numbers are kept of each time. */
  private static int kept(Expr expr) {
    return expr instanceof Expr.Over ? 2 : 1;
  }

  private void load(SeriesLoad load) {
    List<SeriesLoad> more = new ArrayList<>(loads);
    more.add(load);
    loads = List.copyOf(more);
    background.execute(load);
  }

  private static long expected(Expr expr, Map<SourceId, WholeTrace.Place> places) {
    SourceId first = expr.fields().findFirst().orElseThrow().source();
    return places.get(first).history().count(first.port());
  }

  private void drop(Set<Expr> kept) {
    traces.values().stream().filter(trace -> !kept.contains(trace.expr())).toList().forEach(this::drop);
  }

  private void drop(WholeTrace trace) {
    trace.drop();
    traces.remove(trace.expr());
  }

  /** Those of which all sources are recorded. */
  private Map<Expr, Map<SourceId, WholeTrace.Place>> recorded(Set<Expr> wanted) {
    Map<SourceId, Optional<WholeTrace.Place>> known = new HashMap<>();
    Map<StreamHistory, Long> offsets = new HashMap<>();
    Map<Expr, Map<SourceId, WholeTrace.Place>> recorded = new LinkedHashMap<>();
    for (Expr expr : wanted) {
      List<SourceId> sources = expr.fields().map(Expr.Field::source).distinct().toList();
      sources.forEach(source -> known.computeIfAbsent(source, s -> input.history(s).map(
          history -> new WholeTrace.Place(history, offsets.computeIfAbsent(history, StreamHistory::offset)))));
      if (sources.stream().allMatch(source -> known.get(source).isPresent())) {
        Map<SourceId, WholeTrace.Place> places = new HashMap<>();
        sources.forEach(source -> places.put(source, known.get(source).orElseThrow()));
        recorded.put(expr, places);
      }
    }
    return recorded;
  }

  Optional<WholeTrace> trace(Expr expr) {
    return Optional.ofNullable(traces.get(expr));
  }

  /** Ends all reading. */
  void close() {
    drop(Set.of());
  }

  /** Where the recordings stand; nothing where all is live. */
  Optional<Replay> replay() {
    return traces.values().stream().flatMap(trace -> trace.places().values().stream()).map(WholeSeries::span)
        .reduce(TimeSpan::union).map(span -> replay(span, traces.values().iterator().next()));
  }

  private Replay replay(TimeSpan span, WholeTrace any) {
    Timeline timeline = any.places().values().iterator().next().history().timeline();
    TimelineState state = timeline.state();
    Supplier<OptionalDouble> progress = () -> loads.stream().filter(SeriesLoad::isWanted)
        .mapToDouble(SeriesLoad::progress).min();
    return new Replay(timeline, span, state.position(), state.playing(), progress.get());
  }

  private static TimeSpan span(WholeTrace.Place place) {
    TimeRange own = place.history().span();
    return new TimeSpan(own.start() + place.offset(), own.end() + place.offset());
  }
}
