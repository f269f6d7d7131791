package org.robotui.uic.plot.internal.model;

import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.NumberField;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.uic.plot.internal.signal.Expr;
import org.robotui.uic.plot.internal.signal.Pipeline;
import org.robotui.uic.plot.internal.signal.Sink;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/** Takes one field out of the values of its source into a trace; notes what is lost, late or missing. Worker only. */
final class Leaf {
  private static final long JUMP = TimeSpan.SECOND;

  private final Expr.Field field;
  private final NumberField reader;
  private final Sink sink;
  private final double gap;
  private final Cadence cadence;
  /** Plain numbers, as an object for each of millions of samples takes its time; nothing counts before the first. */
  private boolean begun;
  private long last;
  private boolean counted;
  private long sequence;
  private Optional<String> problem = Optional.empty();
  private Optional<String> schema = Optional.empty();
  private long late;

  Leaf(Pipeline.Input input, double gap) {
    this.field = input.field();
    this.reader = new NumberField(FieldPath.parse(field.path()));
    this.sink = input.sink();
    this.gap = gap;
    this.cadence = new Cadence(gap);
  }

  Expr.Field field() {
    return field;
  }

  double gap() {
    return gap;
  }

  Optional<String> problem() {
    return problem;
  }

  /** What the record is called in which the field was found. */
  Optional<String> schema() {
    return schema;
  }

  /** Values that came with a time before that of the newest, and were left out. */
  long late() {
    return late;
  }

  /** Whether a time lies so far back that the clock was set anew. */
  boolean jumpsBack(long time) {
    return begun && time < last - JUMP;
  }

  /** Takes what was recorded before. */
  void replay(long time, double value) {
    sink.accept(time, value);
    last = time;
    begun = true;
  }

  /** Takes a value, given the number that its source gave it; says what was lost before it. */
  Optional<Loss> take(long number, long time, DynamicRecord data, Supplier<DynamicRecord> own) {
    if (begun && time < last) {
      late++;
      sequence = number;
      counted = true;
      return Optional.empty();
    }
    Optional<Loss> loss = breakBefore(number, time);
    switch (reader.read(data, own)) {
      case NumberField.Number n -> number(time, n);
      case NumberField.Missing m -> missing(time, m.reason());
    }
    last = time;
    begun = true;
    return loss;
  }

  private void number(long time, NumberField.Number found) {
    problem = Optional.empty();
    if (schema.isEmpty()) {
      schema = Optional.of(found.schema());
    }
    sink.accept(time, found.value());
  }

  private void missing(long time, String reason) {
    if (problem.isEmpty()) {
      sink.accept(time, Double.NaN);
    }
    problem = Optional.of(reason);
  }

  private Optional<Loss> breakBefore(long next, long time) {
    long lost = counted ? next - sequence - 1 : 0;
    boolean silent = begun && cadence.silent(time - last);
    sequence = next;
    counted = true;
    if (!begun || lost == 0 && !silent) {
      return Optional.empty();
    }
    sink.accept(time, Double.NaN);
    return lost > 0 ? Optional.of(new Loss(last, time, lost)) : Optional.empty();
  }
}
