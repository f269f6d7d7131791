package org.robotui.testkit.rfic;

import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robotui.data.Data;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/** Compares data by their fields; numbers may differ by what is lost in a float. */
final class Alike {
  private static final double TOLERANCE = 1e-5;

  private Alike() {}

  /** The first field that differs, with both values; none where they are alike. */
  static Optional<String> difference(Data expected, Data actual) {
    return expected.getClass().equals(actual.getClass())
        ? fields("", DataRecord.of(expected), DataRecord.of(actual)).findFirst()
        : Optional
            .of("a " + actual.getClass().getSimpleName() + " instead of a " + expected.getClass().getSimpleName());
  }

  private static Stream<String> fields(String path, DynamicRecord expected, DynamicRecord actual) {
    return expected.fields().stream()
        .flatMap(name -> values(path + "." + name, expected.field(name), actual.field(name)));
  }

  private static Stream<String> values(String path, Optional<FieldValue> expected, Optional<FieldValue> actual) {
    if (expected.isEmpty() || actual.isEmpty()) {
      return same(expected.isEmpty() == actual.isEmpty(), path, expected, actual);
    }
    return switch (expected.get()) {
      case FieldValue.Num e when actual.get() instanceof FieldValue.Num a -> same(near(e.value(), a.value()), path, e,
          a);
      case FieldValue.Numbers e when actual.get() instanceof FieldValue.Numbers a -> same(near(e.values(), a.values()),
          path, e, a);
      case FieldValue.Nested e when actual.get() instanceof FieldValue.Nested a -> fields(path, e.value(), a.value());
      case FieldValue.Items e when actual.get() instanceof FieldValue.Items a
          && e.values().size() == a.values().size() -> IntStream.range(0, e.values().size()).boxed().flatMap(
              i -> values(path + "[" + i + "]", Optional.of(e.values().get(i)), Optional.of(a.values().get(i))));
      case FieldValue e -> same(e.equals(actual.get()), path, e, actual.get());
    };
  }

  private static Stream<String> same(boolean same, String path, Object expected, Object actual) {
    return same ? Stream.empty() : Stream.of(path.substring(1) + " is " + actual + " instead of " + expected);
  }

  private static boolean near(double expected, double actual) {
    return Double.compare(expected, actual) == 0
        || Math.abs(expected - actual) <= TOLERANCE * Math.max(1, Math.abs(expected));
  }

  private static boolean near(Doubles expected, Doubles actual) {
    return expected.size() == actual.size()
        && IntStream.range(0, expected.size()).allMatch(i -> near(expected.get(i), actual.get(i)));
  }
}
