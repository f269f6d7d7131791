package org.robotui.uic.plot.internal.model;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RobotClock;
import org.robotui.data.Data;
import org.robotui.data.record.DynamicRecord;
import org.robotui.uic.plot.internal.signal.Expr;

/**
 * Records the signals that are configured, asks robots for what they need and for nothing else, and says how each is
 * doing. {@link #tick} is called by the worker; {@link #watch} and {@link #newest} by any thread.
 */
public final class PlotEngine {
  private final Input<Data> input;
  private final RobotClock clock;
  private final SettingsStore settings;
  private final SampleClock times;
  private final WholeSeries whole;
  private final SignalTable signals = new SignalTable();
  private final Map<Expr, LiveTrace> traces = new LinkedHashMap<>();
  private final Map<SourceId, Envelope<Data>> newest = new ConcurrentHashMap<>();
  private volatile Set<SourceId> watched = Set.of();
  private Settings read;
  private PlotSpec spec;
  private Set<SourceId> chosen = Set.of();
  private long epoch;
  private boolean renewed = true;
  private int taken;

  public PlotEngine(Input<Data> input, RobotClock clock, SettingsStore settings, WholeSeries whole) {
    this.input = input;
    this.whole = whole;
    this.clock = clock;
    this.settings = settings;
    this.read = settings.current();
    this.spec = PlotCodec.read(read);
    this.epoch = clock.epoch();
    this.times = new SampleClock(clock, System.currentTimeMillis() * 1_000_000L, System.nanoTime());
    times.reset(spec.byStamp());
  }

  /** Goes on with what another one has recorded, which records no more. */
  public PlotEngine(Input<Data> input, RobotClock clock, SettingsStore settings, WholeSeries whole,
      PlotEngine before) {
    this.input = input;
    this.whole = whole;
    this.clock = clock;
    this.settings = settings;
    this.read = before.read;
    this.spec = before.spec;
    this.epoch = before.epoch;
    this.times = before.times;
    this.traces.putAll(before.traces);
  }

  /** Has robots asked for these too, to learn what fields they have. */
  public void watch(Set<SourceId> sources) {
    watched = Set.copyOf(sources);
  }

  /** The newest value of a watched source. */
  public Optional<Envelope<Data>> newest(SourceId source) {
    return Optional.ofNullable(newest.get(source));
  }

  /** What is to be shown before anything came. */
  public PlotScene begin(long nowNanos) {
    configure();
    return scene(times.now(nowNanos));
  }

  /** Takes what came; gives what is to be shown. */
  public PlotScene tick(long nowNanos) {
    configure();
    whole.follow(Set.copyOf(traces.keySet()), new WholeSeries.Rules(spec.byStamp(), read.number(PlotOptions.GAP),
        read.integer(PlotOptions.MEMORY)));
    choose();
    if (clock.epoch() != epoch) {
      epoch = clock.epoch();
      restart();
      input.recall();
    }
    taken = input.drain(envelope -> take(envelope, nowNanos));
    if (taken > 0) {
      times.arrived();
    }
    return scene(times.now(nowNanos));
  }

  /** Whether the last tick took anything. */
  public boolean tookValues() {
    return taken > 0;
  }

  private void configure() {
    Settings current = settings.current();
    if (renewed || !current.values().equals(read.values())) {
      boolean byStamp = spec.byStamp();
      boolean kept = current.values().get(PlotOptions.MEMORY).equals(read.values().get(PlotOptions.MEMORY))
          && current.values().get(PlotOptions.GAP).equals(read.values().get(PlotOptions.GAP));
      read = current;
      spec = PlotCodec.read(current);
      reconcile(kept);
      if (byStamp != spec.byStamp()) {
        restart();
      }
      renewed = false;
    }
  }

  private void reconcile(boolean keep) {
    if (!keep) {
      traces.clear();
    }
    signals.follow(spec);
    Set<Expr> exprs = signals.wanted(spec);
    List<LiveTrace> made = new ArrayList<>();
    for (Expr expr : exprs) {
      traces.computeIfAbsent(expr, e -> {
        LiveTrace trace = new LiveTrace(e, read.integer(PlotOptions.MEMORY), read.number(PlotOptions.GAP));
        made.add(trace);
        return trace;
      });
    }
    // What is derived anew begins with what was recorded of its fields, before those that are shown no more go.
    made.forEach(trace -> trace.replay(traces));
    traces.keySet().retainAll(exprs);
  }

  private void restart() {
    traces.values().forEach(LiveTrace::restart);
    times.reset(spec.byStamp());
  }

  private void choose() {
    Set<SourceId> wanted = new HashSet<>(watched);
    traces.keySet().stream().filter(expr -> whole.trace(expr).isEmpty())
        .forEach(expr -> expr.fields().map(Expr.Field::source).forEach(wanted::add));
    if (!wanted.equals(chosen)) {
      chosen = Set.copyOf(wanted);
      input.choose(chosen);
      newest.keySet().retainAll(chosen);
    }
  }

  private void take(Envelope<Data> envelope, long nowNanos) {
    if (!chosen.contains(envelope.source())) {
      return;
    }
    newest.put(envelope.source(), envelope);
    long time = times.timeOf(envelope, nowNanos);
    DynamicRecord data = Records.data(envelope);
    for (LiveTrace trace : traces.values()) {
      trace.take(envelope, time, data, () -> Records.own(envelope));
    }
  }

  private PlotScene scene(long now) {
    Sources sources = new Sources(input);
    List<List<TraceView>> axes = spec.axes().stream()
        .map(axis -> IntStream.range(0, axis.traces().size()).mapToObj(i -> view(axis, i, sources)).toList()).toList();
    return new PlotScene(spec, TraceNames.told(axes), now, whole.replay());
  }

  private TraceView view(AxisSpec axis, int index, Sources sources) {
    TraceSpec trace = axis.traces().get(index);
    Signal signal = signals.of(axis, trace);
    return signal.expr().map(expr -> whole.trace(expr).map(all -> view(trace, axis.colour(index), all))
        .orElseGet(() -> view(trace, axis.colour(index), traces.get(expr), sources)))
        .orElseGet(() -> new TraceView(trace, axis.colour(index), trace.label().orElse(trace.signal()), "", "",
            Optional.empty(),
            Sources.WRONG, signal.error(), List.of(), 0));
  }

  private static TraceView view(TraceSpec spec, int colour, LiveTrace trace, Sources sources) {
    return new TraceView(spec, colour, spec.label().orElseGet(() -> Labels.of(trace.expr())),
        Labels.sources(trace.expr()), spec.unit().orElseGet(() -> trace.unit(trace.expr())),
        Optional.of(trace.series()), sources.state(trace.expr()), trace.problem(), trace.losses(), trace.late(),
        Optional.empty(), over(trace.expr(), trace.store(), trace::unit));
  }

  private static TraceView view(TraceSpec spec, int colour, WholeTrace trace) {
    return new TraceView(spec, colour, spec.label().orElseGet(() -> Labels.of(trace.expr())),
        Labels.sources(trace.expr()), spec.unit().orElseGet(trace::unit), Optional.of(trace.series()), trace.state(),
        trace.problem(), List.of(), trace.late(), Optional.of(trace.remark()),
        over(trace.expr(), trace.store(), x -> trace.unitAcross()));
  }

  private static Optional<CurveView> over(Expr expr, SampleStore store, Function<Expr, String> unit) {
    return expr instanceof Expr.Over over
        ? store.curve()
            .map(curve -> new CurveView(curve, over.x().toString(), Labels.of(over.x()), unit.apply(over.x())))
        : Optional.empty();
  }

  /** Ends what goes on beside ticks. Any thread, when there are no more of them. */
  public void close() {
    whole.close();
  }
}
