package org.robotui.api.bridge;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;

/**
 * What a field of a message is made of: a text, a value of any kind as {@link FieldExpression} has it, or a number that
 * is calculated of several ones, such as {@code sqrt(v.x * v.x + v.y * v.y)}. Immutable.
 */
public final class FieldFormula {
  private final List<String> paths;
  private final Function<DynamicRecord, Optional<FieldValue>> value;

  FieldFormula(List<String> paths, Function<DynamicRecord, Optional<FieldValue>> value) {
    this.paths = List.copyOf(paths);
    this.value = value;
  }

  /**
   * Reads a formula: what {@link FieldExpression} takes, or numbers and paths with {@code + - * /}, parentheses, and
   * the functions {@code abs sqrt sin cos tan asin acos atan floor round rad deg} of one and {@code atan2 min max} of
   * two numbers.
   *
   * @param text such as {@code 2 * (x - y)}
   * @return the formula
   * @throws IllegalArgumentException with a reason where it is none
   */
  public static FieldFormula parse(String text) {
    Optional<FieldExpression> plain = FieldExpression.find(text);
    return plain.isPresent() ? of(plain.get()) : new FormulaParser(text).formula();
  }

  private static FieldFormula of(FieldExpression plain) {
    return new FieldFormula(plain.constant().isPresent() ? List.of() : List.of(plain.path()), plain::of);
  }

  /**
   * The value that it has for a record.
   *
   * @param record any record
   * @return the value, or none where one of the paths leads nowhere
   * @throws IllegalArgumentException where something else than a number is to be calculated with, or the result is not
   * finite
   */
  public Optional<FieldValue> of(DynamicRecord record) {
    return value.apply(record);
  }

  /**
   * What it reads that a record does not have.
   *
   * @param record any record
   * @return the path that leads nowhere, or none
   */
  public Optional<String> missing(DynamicRecord record) {
    return paths.stream().filter(path -> record.at(FieldPath.parse(path)).isEmpty()).findFirst();
  }
}
