package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.record.FieldUnits;
import org.robotui.uic.plot.internal.signal.Expr;
import org.robotui.uic.plot.internal.trace.Series;

/** A signal of recordings, read whole. Filled by one thread, looked at by others. */
final class WholeTrace {
  /** Where the values of a source come from. */
  record Place(StreamHistory history, long offset) {}

  /** What is known so far beside the samples. */
  private record Found(Optional<String> problem, String unit, String across, long late, String refused) {
    static final Found NOTHING = new Found(Optional.empty(), "", "", 0, "");
  }

  private final Expr expr;
  private final Map<SourceId, Place> places;
  private final SampleStore store;
  private final int every;
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
    this.every = SampleStore.every(expr, expected, most);
    this.store = SampleStore.of(expr, most, every);
    this.leaves = store.begin().inputs().stream().map(input -> new Leaf(input, gap)).toList();
  }

  Expr expr() {
    return expr;
  }

  Map<SourceId, Place> places() {
    return places;
  }

  SampleStore store() {
    return store;
  }

  Series series() {
    return store.series();
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
    String across = expr instanceof Expr.Over over ? unit(over.x()) : "";
    found = new Found(leaves.stream().flatMap(l -> l.problem().stream()).findFirst(), unit(expr), across,
        leaves.stream().mapToLong(Leaf::late).sum(),
        refused == 0 ? "" : refused + " messages cannot be used: " + complaint);
  }

  private String unit(Expr part) {
    return Units.of(part, f -> leaves.stream().filter(l -> l.field().equals(f)).findFirst()
        .flatMap(Leaf::schema).map(schema -> FieldUnits.of(schema, f.path())).orElse(""));
  }

  void end() {
    store.flush();
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

  /** Of what it is shown over. */
  String unitAcross() {
    return found.across();
  }

  long late() {
    return found.late();
  }

  Optional<String> problem() {
    boolean nothing = series().size() == 0 && !found.refused().isEmpty();
    return failure.or(() -> found.problem()).or(() -> nothing ? Optional.of(found.refused()) : Optional.empty());
  }

  InputState state() {
    return series().size() == 0 && !done ? new InputState.Waiting("the recording is being read")
        : new InputState.Live(0, 0);
  }

  /** What is to be said of it beside what a live trace says. */
  String remark() {
    String thinned = every > 1
        ? "\nof each " + every + " samples those that go furthest are kept, as memory is limited"
        : "";
    String unusable = found.refused().isEmpty() ? "" : "\n" + found.refused();
    return (done ? "the whole recording" : "the recording is being read") + thinned + unusable;
  }
}
