package org.robotui.uic.diagnostics.internal.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongUnaryOperator;
import org.robotui.api.port.SourceId;
import org.robotui.data.status.Diagnostics;
import org.robotui.testkit.FakeInput;

/** Diagnostics in a test's hands: seconds are given by the test; one slot of the history is a second. */
final class Bench {
  static final SourceId RAW = new SourceId("base", "/diagnostics");
  static final SourceId SORTED = new SourceId("base", "/diagnostics_agg");
  static final long SECOND = 1_000_000_000L;
  static final double STALE = 5;

  final FakeInput<Diagnostics> input = new FakeInput<>();
  /** Where this is not that of the machine: as in a recording. */
  LongUnaryOperator aging = LongUnaryOperator.identity();
  final DiagnosticsModel model =
      new DiagnosticsModel(input, DiagnosticsModel.SLOTS / 60, nanos -> aging.applyAsLong(nanos));

  static Diagnostics.Item item(String name, Diagnostics.Level level, String message, String... values) {
    Map<String, String> details = new LinkedHashMap<>();
    for (int i = 0; i < values.length; i += 2) {
      details.put(values[i], values[i + 1]);
    }
    return new Diagnostics.Item(name, "", level, message, details);
  }

  static Diagnostics.Item ok(String name) {
    return item(name, Diagnostics.Level.OK, "fine");
  }

  static Diagnostics.Item error(String name) {
    return item(name, Diagnostics.Level.ERROR, "broken");
  }

  Bench say(SourceId source, double second, Diagnostics.Item... items) {
    input.put(source, new Diagnostics(List.of(items)), (long) (second * SECOND), Optional.empty());
    return this;
  }

  Bench say(double second, Diagnostics.Item... items) {
    return say(RAW, second, items);
  }

  Shown at(double second) {
    model.tick((long) (second * SECOND), STALE);
    return model.current();
  }

  List<String> lines(double second) {
    return at(second).rows().stream().map(row -> "  ".repeat(row.depth()) + row.label() + " " + row.level().word())
        .toList();
  }

  DiagnosticsRow row(double second, String label) {
    return at(second).rows().stream().filter(row -> row.label().equals(label)).findFirst().orElseThrow();
  }
}
