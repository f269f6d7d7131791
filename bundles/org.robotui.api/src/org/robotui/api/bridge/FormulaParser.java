package org.robotui.api.bridge;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.api.input.Numerals;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;

/** Reads sums of products from a text, once. */
final class FormulaParser {
  private static final int LONGEST = 500; // each parenthesis is a call deeper
  private static final Pattern NUMBER = Pattern.compile("(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?");
  private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");
  private static final Pattern PATH = Pattern.compile("[A-Za-z_]\\w*(?:\\.[A-Za-z_]\\w*|\\[\\d{1,9}])*");
  private static final Map<String, DoubleUnaryOperator> OF_ONE = Map.ofEntries(Map.entry("abs", Math::abs),
      Map.entry("sqrt", Math::sqrt), Map.entry("sin", Math::sin), Map.entry("cos", Math::cos),
      Map.entry("tan", Math::tan), Map.entry("asin", Math::asin), Map.entry("acos", Math::acos),
      Map.entry("atan", Math::atan), Map.entry("floor", Math::floor), Map.entry("round", Math::rint),
      Map.entry("rad", Math::toRadians), Map.entry("deg", Math::toDegrees));
  private static final Map<String, DoubleBinaryOperator> OF_TWO =
      Map.of("atan2", Math::atan2, "min", Math::min, "max", Math::max);

  private final String text;
  private final List<String> paths = new ArrayList<>();
  private int at;

  /** A part of a formula. */
  private interface Term extends ToDoubleFunction<DynamicRecord> {}

  FormulaParser(String text) {
    this.text = text;
    if (text.length() > LONGEST) {
      throw new IllegalArgumentException("a formula has " + LONGEST + " characters at most");
    }
  }

  FieldFormula formula() {
    Term whole = sum();
    if (peek() != 0) {
      throw wrong();
    }
    return new FieldFormula(paths, record -> value(whole, record));
  }

  private Optional<FieldValue> value(Term whole, DynamicRecord record) {
    if (paths.stream().anyMatch(path -> record.at(FieldPath.parse(path)).isEmpty())) {
      return Optional.empty();
    }
    double number = whole.applyAsDouble(record);
    if (!Double.isFinite(number)) {
      throw new IllegalArgumentException("'" + text + "' is " + number);
    }
    return Optional.of(FieldExpression.number(number));
  }

  private IllegalArgumentException wrong() {
    return new IllegalArgumentException("'" + text + "' is no path, number, formula or text in single quotes"
        + (at < text.length() ? "; '" + text.substring(at) + "' does not fit" : "; it ends too early"));
  }

  /** The next character that is no space, or 0 at the end. */
  private char peek() {
    while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
      at++;
    }
    return at < text.length() ? text.charAt(at) : 0;
  }

  private boolean takes(char wanted) {
    boolean there = peek() == wanted;
    at += there ? 1 : 0;
    return there;
  }

  private void needs(char wanted) {
    if (!takes(wanted)) {
      throw wrong();
    }
  }

  private Optional<String> takes(Pattern pattern) {
    peek();
    Matcher matcher = pattern.matcher(text).region(at, text.length());
    if (!matcher.lookingAt()) {
      return Optional.empty();
    }
    at = matcher.end();
    return Optional.of(matcher.group());
  }

  private Term sum() {
    Term left = product();
    while (peek() == '+' || peek() == '-') {
      boolean minus = takes('-') || !takes('+');
      left = joined(left, product(), minus ? (a, b) -> a - b : Double::sum);
    }
    return left;
  }

  private Term product() {
    Term left = factor();
    while (peek() == '*' || peek() == '/') {
      boolean over = takes('/') || !takes('*');
      left = joined(left, factor(), over ? (a, b) -> a / b : (a, b) -> a * b);
    }
    return left;
  }

  private static Term joined(Term left, Term right, DoubleBinaryOperator by) {
    return record -> by.applyAsDouble(left.applyAsDouble(record), right.applyAsDouble(record));
  }

  private Term factor() {
    if (takes('-')) {
      Term inner = factor();
      return record -> -inner.applyAsDouble(record);
    }
    if (takes('(')) {
      Term inner = sum();
      needs(')');
      return inner;
    }
    Optional<String> number = takes(NUMBER);
    if (number.isPresent()) {
      double constant = Numerals.decimal(number.get()).orElseThrow(this::wrong);
      return record -> constant;
    }
    return named();
  }

  private Term named() {
    int begin = at;
    String name = takes(NAME).orElseThrow(this::wrong);
    if (takes('(')) {
      return function(name);
    }
    at = begin;
    String path = takes(PATH).orElseThrow(this::wrong);
    FieldPath parsed = FieldPath.parse(path);
    paths.add(path);
    String problem = "'" + path + "' is no number: nothing can be calculated of it";
    return record -> number(record, parsed).orElseThrow(() -> new IllegalArgumentException(problem));
  }

  private Term function(String name) {
    Term first = sum();
    DoubleUnaryOperator ofOne = OF_ONE.get(name);
    if (ofOne != null) {
      needs(')');
      return record -> ofOne.applyAsDouble(first.applyAsDouble(record));
    }
    DoubleBinaryOperator ofTwo = OF_TWO.get(name);
    if (ofTwo == null) {
      throw new IllegalArgumentException("there is no function '" + name + "'");
    }
    needs(',');
    Term second = sum();
    needs(')');
    return joined(first, second, ofTwo);
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
