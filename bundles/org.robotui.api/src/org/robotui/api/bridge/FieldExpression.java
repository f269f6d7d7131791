package org.robotui.api.bridge;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.api.input.Numerals;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;

/**
 * What a field of a message is made of: a constant, or the value at a path, with another unit where it is a number or
 * many numbers.
 *
 * @param constant the constant, where it is one
 * @param path where the value stands in the record; empty for a constant
 * @param factor by which numbers are multiplied
 * @param summand what is added then
 */
public record FieldExpression(Optional<FieldValue> constant, String path, double factor, double summand) {
  private static final String NUMBER = "[+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?";
  private static final Pattern FORM = Pattern.compile(
      "(?<path>[A-Za-z_][A-Za-z0-9_]*(?:\\.[A-Za-z_][A-Za-z0-9_]*|\\[\\d{1,9}])*)"
          + "(?:\\s*\\*\\s*(?<factor>" + NUMBER + "))?(?:\\s*(?<sign>[+-])\\s*(?<summand>\\d[\\d.eE+-]*))?");
  private static final Pattern TEXT = Pattern.compile("'(?<text>[^']*)'");

  /**
   * Reads an expression.
   *
   * @param text such as {@code pose.x * 1000 + 5}, {@code 3.5} or {@code 'base_link'}
   * @return the expression
   * @throws IllegalArgumentException with a reason where it is none
   */
  public static FieldExpression parse(String text) {
    return find(text).orElseThrow(() -> new IllegalArgumentException(
        "'" + text + "' is neither a path, a number nor a text in single quotes"));
  }

  /** The same, or none where it is none. */
  static Optional<FieldExpression> find(String text) {
    String stripped = text.strip();
    Matcher quoted = TEXT.matcher(stripped);
    if (quoted.matches()) {
      return Optional.of(constant(new FieldValue.Text(quoted.group("text"))));
    }
    Optional<Double> number = Numerals.decimal(stripped);
    if (number.isPresent()) {
      return Optional.of(constant(new FieldValue.Num(number.get(), stripped)));
    }
    Matcher form = FORM.matcher(stripped);
    if (!form.matches()) {
      return Optional.empty();
    }
    int sign = "-".equals(form.group("sign")) ? -1 : 1;
    return number(form.group("factor"), 1).flatMap(factor -> number(form.group("summand"), 0)
        .map(summand -> new FieldExpression(Optional.empty(), form.group("path"), factor, sign * summand)));
  }

  private static FieldExpression constant(FieldValue value) {
    return new FieldExpression(Optional.of(value), "", 1, 0);
  }

  private static Optional<Double> number(String text, double otherwise) {
    return text == null ? Optional.of(otherwise) : Numerals.decimal(text);
  }

  /**
   * The value that it has for a record.
   *
   * @param record any record
   * @return the value, or none where the path leads nowhere
   * @throws IllegalArgumentException where what stands there has no unit, but a factor or a summand is given
   */
  public Optional<FieldValue> of(DynamicRecord record) {
    return constant.or(() -> record.at(FieldPath.parse(path)).map(this::inUnit));
  }

  private FieldValue inUnit(FieldValue value) {
    if (factor == 1 && summand == 0) {
      return value;
    }
    return switch (value) {
      case FieldValue.Num n -> number(n.value() * factor + summand);
      case FieldValue.Time t -> number(t.nanos() * factor + summand);
      case FieldValue.Flag f -> number((f.value() ? 1 : 0) * factor + summand);
      case FieldValue.Numbers n -> {
        double[] values = new double[n.values().size()];
        for (int i = 0; i < values.length; i++) {
          values[i] = n.values().get(i) * factor + summand;
        }
        yield new FieldValue.Numbers(Doubles.wrap(values));
      }
      default -> throw new IllegalArgumentException("'" + path + "' is no number: it cannot be multiplied or added to");
    };
  }

  /** A number as it is written. */
  static FieldValue number(double value) {
    boolean whole = value == Math.rint(value) && Math.abs(value) < 1L << 53;
    return new FieldValue.Num(value, whole ? Long.toString((long) value) : Double.toString(value));
  }
}
