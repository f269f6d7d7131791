package org.robotui.api.port;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.NumberPath;

/** Reads a number at a path of records, and says what is there instead where there is none. For one thread. */
public final class NumberField {
  private static final double NANO = 1e-9;
  private static final int MOST_NAMED = 12;

  private final FieldPath path;
  private final NumberPath numberPath;

  /**
   * For a path.
   *
   * @param path of a field
   */
  public NumberField(FieldPath path) {
    this.path = path;
    numberPath = new NumberPath(path);
  }

  /** What was found. */
  public sealed interface Found {}

  /**
   * A number.
   *
   * @param value truth values are 0 and 1, times seconds
   * @param schema what the record is called in which it was found
   */
  public record Number(double value, String schema) implements Found {}

  /**
   * Nothing.
   *
   * @param reason what is missing, and what there is instead
   */
  public record Missing(String reason) implements Found {}

  /**
   * Looks in the data record first, then in the record in the robot's own names.
   *
   * @param data by the names of data records
   * @param own by the robot's own names; asked for only where the data record has no such field
   * @return the number, or why there is none
   */
  public Found read(DynamicRecord data, Supplier<DynamicRecord> own) {
    OptionalDouble number = numberPath.in(data);
    if (number.isPresent()) {
      return new Number(number.getAsDouble(), data.schema());
    }
    Optional<FieldValue> value = data.at(path);
    if (value.isPresent()) {
      return number(value.get(), data.schema());
    }
    DynamicRecord robots = own.get();
    return robots.at(path).map(v -> number(v, robots.schema())).orElseGet(() -> new Missing(reason(data, robots)));
  }

  /**
   * The number that a value means.
   *
   * @param value of a field
   * @return 0 and 1 for truth values, seconds for times; none for texts, lists and groups
   */
  public static Optional<Double> number(FieldValue value) {
    return switch (value) {
      case FieldValue.Num n -> Optional.of(n.value());
      case FieldValue.Flag f -> Optional.of(f.value() ? 1.0 : 0.0);
      case FieldValue.Time t -> Optional.of(t.nanos() * NANO);
      default -> Optional.empty();
    };
  }

  private Found number(FieldValue value, String schema) {
    return number(value).<Found>map(n -> new Number(n, schema))
        .orElseGet(() -> new Missing(path + " of " + schema + " is " + noun(value)));
  }

  private static String noun(FieldValue value) {
    return switch (value) {
      case FieldValue.Text t -> "a text, not a number";
      case FieldValue.Numbers n -> "a list of " + n.values().size() + " numbers; write one of them as [0]";
      case FieldValue.Items i -> "a list of " + i.values().size() + "; write one of them as [0]";
      case FieldValue.Nested n -> "a group; fields there are: " + names(n.value().fields());
      default -> "no number";
    };
  }

  private String reason(DynamicRecord data, DynamicRecord own) {
    DynamicRecord deepest = deepest(data).size() >= deepest(own).size() ? data : own;
    List<FieldPath.Step> reached = deepest(deepest);
    String missing =
        new FieldPath(path.steps().subList(0, Math.min(path.steps().size(), reached.size() + 1))).toString();
    return deepest.schema() + " has no field '" + missing + "'" + there(deepest, reached);
  }

  /** How far the path leads. */
  private List<FieldPath.Step> deepest(DynamicRecord record) {
    int reached = 0;
    while (reached < path.steps().size()
        && record.at(new FieldPath(path.steps().subList(0, reached + 1))).isPresent()) {
      reached++;
    }
    return path.steps().subList(0, reached);
  }

  private static String there(DynamicRecord record, List<FieldPath.Step> reached) {
    FieldValue at = reached.isEmpty() ? new FieldValue.Nested(record) : record.at(new FieldPath(reached)).orElseThrow();
    return switch (at) {
      case FieldValue.Nested n -> "; fields there are: " + names(n.value().fields());
      case FieldValue.Numbers n -> "; " + new FieldPath(reached) + " has " + n.values().size() + " elements";
      case FieldValue.Items i -> "; " + new FieldPath(reached) + " has " + i.values().size() + " elements";
      default -> "; " + new FieldPath(reached) + " has no fields";
    };
  }

  private static String names(List<String> fields) {
    String names = fields.stream().limit(MOST_NAMED).collect(Collectors.joining(", "));
    return fields.size() > MOST_NAMED ? names + ", \u2026" : names;
  }
}
