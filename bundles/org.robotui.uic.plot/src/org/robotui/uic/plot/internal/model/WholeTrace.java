package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.uic.plot.internal.signal.Expr;
import org.robotui.uic.plot.internal.signal.Pipeline;
import org.robotui.uic.plot.internal.signal.ThinningSink;
import org.robotui.uic.plot.internal.trace.Series;

/** A signal of recordings, read whole. Filled by one thread, looked at by others. */
final class WholeTrace {
  /** Where the values of a source come from. */
  record Place(StreamHistory history, long offset) {}

  /** What is known so far beside the samples. */
  private record Found(Optional<String> problem, String unit, long late, String refused) {
    static final Found NOTHING = new Found(Optional.empty(), "", 0, "");
  }

  private final Expr expr;
  private final Map<SourceId, Place> places;
  private final Series series;
  private final int every;
  private final ThinningSink thinning;
  private final List<Leaf> leaves;
  private String complaint = "";
  private long refused;
  private volatile Found found = Found.NOTHING;
  private volatile boolean wanted = true;
  private volatile boolean done;
  private volatile Optional<String> failure = Optional.empty();

  /**
   * Empty.
   *
   * @param most how many samples there is room for
   * @param expected how many come
   */
  WholeTrace(Expr expr, Map<SourceId, Place> places, double gap, long most, long expected) {
    this.expr = expr;
    this.places = Map.copyOf(places);
    this.every = expected > most ? Math.toIntExact(Math.min(Integer.MAX_VALUE, 2 * Math.ceilDiv(expected, most))) : 1;
    this.series = new Series(most);
    this.thinning = new ThinningSink(every, series::add);
    this.leaves = Pipeline.of(expr, thinning).inputs().stream().map(input -> new Leaf(input, gap)).toList();
  }

  Expr expr() {
    return expr;
  }

  Map<SourceId, Place> places() {
    return places;
  }

  Series series() {
    return series;
  }

  List<Leaf> leaves() {
    return leaves;
  }

  /** Whether its values come from one recording, in the order of time. */
  boolean isOfOne() {
    return places.values().stream().map(Place::history).distinct().count() == 1;
  }

  boolean isWanted() {
    return wanted;
  }

  boolean isDone() {
    return done;
  }

  /** It is shown no more: who reads may end. */
  void drop() {
    wanted = false;
  }

  /** A message of it is no value. */
  void refuse(String reason) {
    complaint = reason;
    refused++;
  }

  /** Has others see what was found so far. */
  void tell() {
    String unit = Units.of(expr, f -> leaves.stream().filter(l -> l.field().equals(f)).findFirst()
        .flatMap(Leaf::schema).map(schema -> Units.of(schema, f.path())).orElse(""));
    found = new Found(leaves.stream().flatMap(l -> l.problem().stream()).findFirst(), unit,
        leaves.stream().mapToLong(Leaf::late).sum(),
        refused == 0 ? "" : refused + " messages cannot be used: " + complaint);
  }

  void end() {
    thinning.flush();
    tell();
    done = true;
  }

  void fail(String reason) {
    failure = Optional.of(reason);
    end();
  }

  String unit() {
    return found.unit();
  }

  long late() {
    return found.late();
  }

  Optional<String> problem() {
    boolean nothing = series.size() == 0 && !found.refused().isEmpty();
    return failure.or(() -> found.problem()).or(() -> nothing ? Optional.of(found.refused()) : Optional.empty());
  }

  InputState state() {
    return series.size() == 0 && !done ? new InputState.Waiting("the recording is being read")
        : new InputState.Live(0, 0);
  }

  /** What is to be said of it beside what a live trace says. */
  String remark() {
    String thinned = every > 1
        ? "\nof each " + every + " samples the smallest and the largest are kept, as memory is limited"
        : "";
    String unusable = found.refused().isEmpty() ? "" : "\n" + found.refused();
    return (done ? "the whole recording" : "the recording is being read") + thinned + unusable;
  }
}
