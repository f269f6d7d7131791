package org.robotui.uic.plot.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.Envelope;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldUnits;
import org.robotui.uic.plot.internal.signal.Expr;
import org.robotui.uic.plot.internal.trace.Samples;
import org.robotui.uic.plot.internal.trace.Series;

/** A signal that is being recorded. Worker only, but for its series. */
final class LiveTrace {
  private static final int MOST_LOSSES = 200;

  private final Expr expr;
  private final SampleStore store;
  private final double gap;
  private final List<Loss> losses = new ArrayList<>();
  private List<Leaf> leaves = List.of();

  LiveTrace(Expr expr, long memory, double gap) {
    this.expr = expr;
    this.store = SampleStore.of(expr, memory, 1);
    this.gap = gap;
    restart();
  }

  Expr expr() {
    return expr;
  }

  SampleStore store() {
    return store;
  }

  Series series() {
    return store.series();
  }

  /** The newest losses, the oldest first. */
  List<Loss> losses() {
    return List.copyOf(losses);
  }

  long late() {
    return leaves.stream().mapToLong(Leaf::late).sum();
  }

  Optional<String> problem() {
    return leaves.stream().flatMap(l -> l.problem().stream()).findFirst();
  }

  /** Of the signal, or of one that it is made of. */
  String unit(Expr part) {
    return Units.of(part, f -> leaves.stream().filter(l -> l.field().equals(f)).findFirst()
        .flatMap(Leaf::schema).map(schema -> FieldUnits.of(schema, f.path())).orElse(""));
  }

  /** Forgets all: the clock was set anew. */
  void restart() {
    losses.clear();
    leaves = store.begin().inputs().stream().map(input -> new Leaf(input, gap)).toList();
  }

  void take(Envelope<?> envelope, long time, DynamicRecord data, Supplier<DynamicRecord> own) {
    if (leaves.stream().anyMatch(leaf -> leaf.field().source().equals(envelope.source()) && leaf.jumpsBack(time))) {
      restart();
    }
    Optional<Loss> loss = Optional.empty();
    for (Leaf leaf : leaves) {
      if (leaf.field().source().equals(envelope.source())) {
        // All fields of a source lose the same values: they count once.
        loss = leaf.take(envelope.sequence(), time, data, own);
      }
    }
    loss.ifPresent(this::note);
  }

  /** Computes from what other traces have recorded of its fields, where all of them are there; in the order of time. */
  void replay(Map<Expr, LiveTrace> recorded) {
    List<Samples> histories = new ArrayList<>();
    for (Leaf leaf : leaves) {
      if (!recorded.containsKey(leaf.field()) || recorded.get(leaf.field()) == this) {
        return;
      }
      histories.add(recorded.get(leaf.field()).series().samples());
    }
    FieldMerge.into(leaves, histories);
  }

  private void note(Loss loss) {
    losses.add(loss);
    if (losses.size() > MOST_LOSSES) {
      losses.removeFirst();
    }
  }
}
