package org.robotui.data.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.data.internal.Check;

/**
 * The address of a field within a record.
 *
 * @param steps from the outermost field inwards
 */
public record FieldPath(List<Step> steps) {
  private static final Pattern STEP = Pattern.compile("([A-Za-z_][A-Za-z0-9_]*)((?:\\[\\d{1,9}])*)");
  private static final Pattern INDEX = Pattern.compile("\\[(\\d{1,9})]");

  /** A step of a path. */
  public sealed interface Step {
    /**
     * Into a field.
     *
     * @param name its name
     */
    record Field(String name) implements Step {}

    /**
     * Into an element.
     *
     * @param index from 0
     */
    record Element(int index) implements Step {}
  }

  /**
   * Copies the list.
   *
   * @param steps the steps
   */
  public FieldPath {
    steps = List.copyOf(steps);
  }

  /**
   * Parses a path.
   *
   * @param text for example {@code pose.position.x} or {@code ranges[3]}
   * @return the path
   * @throws IllegalArgumentException where the text is no path; the message names the part
   */
  public static FieldPath parse(String text) {
    List<Step> steps = new ArrayList<>();
    for (String part : text.split("\\.", -1)) {
      Matcher m = STEP.matcher(part);
      Check.that(m.matches(), "path '" + text + "'", "'" + part + "' is no field name with optional [index]");
      steps.add(new Step.Field(m.group(1)));
      INDEX.matcher(m.group(2)).results().forEach(r -> steps.add(new Step.Element(Integer.parseInt(r.group(1)))));
    }
    return new FieldPath(steps);
  }

  /**
   * Follows the path.
   *
   * @param record where to start
   * @return the value, or none where the path leads nowhere
   */
  public Optional<FieldValue> in(DynamicRecord record) {
    Optional<FieldValue> at = Optional.of(new FieldValue.Nested(record));
    for (Step step : steps) {
      at = at.flatMap(value -> follow(value, step));
    }
    return at;
  }

  private static Optional<FieldValue> follow(FieldValue value, Step step) {
    return switch (step) {
      case Step.Field f -> value instanceof FieldValue.Nested n ? n.value().field(f.name()) : Optional.empty();
      case Step.Element e -> element(value, e.index());
    };
  }

  private static Optional<FieldValue> element(FieldValue value, int index) {
    return switch (value) {
      case FieldValue.Numbers n when index < n.values().size() -> {
        double number = n.values().get(index);
        yield Optional.of(new FieldValue.Num(number, Double.toString(number)));
      }
      case FieldValue.Items i when index < i.values().size() -> Optional.of(i.values().get(index));
      default -> Optional.empty();
    };
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    for (Step step : steps) {
      switch (step) {
        case Step.Field f -> text.append(text.isEmpty() ? "" : ".").append(f.name());
        case Step.Element e -> text.append('[').append(e.index()).append(']');
      }
    }
    return text.toString();
  }
}
