package org.robotui.api.bridge;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.regex.Pattern;
import org.robotui.api.input.FormulaGrammar;
import org.robotui.api.input.Numerals;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;

/** Reads formulas of the fields of a record from a text, once. */
final class FormulaParser extends FormulaGrammar<FormulaParser.Term> {
  private static final int LONGEST = 500;
  private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");
  private static final Pattern PATH = Pattern.compile("[A-Za-z_]\\w*(?:\\.[A-Za-z_]\\w*|\\[\\d{1,9}])*");

  private final List<String> paths = new ArrayList<>();

  /** A part of a formula. */
  interface Term extends ToDoubleFunction<DynamicRecord> {}

  FormulaParser(String text) {
    super(text, LONGEST);
    if (text.length() > LONGEST) {
      throw new IllegalArgumentException("a formula has " + LONGEST + " characters at most");
    }
  }

  FieldFormula formula() {
    Term whole = whole();
    return new FieldFormula(paths, record -> value(whole, record));
  }

  private Optional<FieldValue> value(Term whole, DynamicRecord record) {
    if (paths.stream().anyMatch(path -> record.at(FieldPath.parse(path)).isEmpty())) {
      return Optional.empty();
    }
    double number = whole.applyAsDouble(record);
    if (!Double.isFinite(number)) {
      throw new IllegalArgumentException("'" + text() + "' is " + number);
    }
    return Optional.of(FieldExpression.number(number));
  }

  @Override
  protected IllegalArgumentException wrong(String missing) {
    return new IllegalArgumentException("'" + text() + "' is no path, number, formula or text in single quotes"
        + (at() < text().length() ? "; '" + text().substring(at()) + "' does not fit" : "; it ends too early"));
  }

  @Override
  protected Term one(String function, Term of) {
    DoubleUnaryOperator operator = ofOne(function).orElseThrow();
    return record -> operator.applyAsDouble(of.applyAsDouble(record));
  }

  @Override
  protected Term two(String function, Term left, Term right) {
    DoubleBinaryOperator operator = ofTwo(function).orElseThrow();
    return record -> operator.applyAsDouble(left.applyAsDouble(record), right.applyAsDouble(record));
  }

  @Override
  protected Term operand() {
    Optional<String> number = takes(NUMBER);
    if (number.isPresent()) {
      double constant = Numerals.decimal(number.get()).orElseThrow(() -> wrong(""));
      return record -> constant;
    }
    int begin = at();
    String name = takes(NAME).orElseThrow(() -> wrong(""));
    if (takes('(')) {
      return function(name);
    }
    at(begin);
    String path = takes(PATH).orElseThrow(() -> wrong(""));
    FieldPath parsed = FieldPath.parse(path);
    paths.add(path);
    String problem = "'" + path + "' is no number: nothing can be calculated of it";
    return record -> number(record, parsed).orElseThrow(() -> new IllegalArgumentException(problem));
  }

  private Term function(String name) {
    Term first = sum();
    if (ofOne(name).isPresent()) {
      needs(')');
      return one(name, first);
    }
    if (ofTwo(name).isEmpty()) {
      throw new IllegalArgumentException("there is no function '" + name + "'");
    }
    needs(',');
    Term second = sum();
    needs(')');
    return two(name, first, second);
  }

  private static OptionalDouble number(DynamicRecord record, FieldPath path) {
    return record.at(path).map(value -> switch (value) {
      case FieldValue.Num n -> OptionalDouble.of(n.value());
      case FieldValue.Time t -> OptionalDouble.of(t.nanos());
      case FieldValue.Flag f -> OptionalDouble.of(f.value() ? 1 : 0);
      default -> OptionalDouble.empty();
    }).orElse(OptionalDouble.empty());
  }
}
