package org.robotui.api.input;

import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads formulas: sums of products with parentheses, whatever they are calculated of. Who extends it reads the operands
 * and says what becomes of them. Used once, by one thread.
 *
 * @param <T> a part of a formula
 */
public abstract class FormulaGrammar<T> {
  /** A number without a sign. */
  protected static final Pattern NUMBER = Pattern.compile("(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?");

  private static final Map<String, DoubleUnaryOperator> OF_ONE = Map.ofEntries(Map.entry("abs", Math::abs),
      Map.entry("sqrt", Math::sqrt), Map.entry("sin", Math::sin), Map.entry("cos", Math::cos),
      Map.entry("tan", Math::tan), Map.entry("asin", Math::asin), Map.entry("acos", Math::acos),
      Map.entry("atan", Math::atan), Map.entry("floor", Math::floor), Map.entry("round", Math::rint),
      Map.entry("rad", Math::toRadians), Map.entry("deg", Math::toDegrees), Map.entry("-", a -> -a));
  private static final Map<String, DoubleBinaryOperator> OF_TWO = Map.of("atan2", Math::atan2, "min", Math::min, "max",
      Math::max, "+", Double::sum, "-", (a, b) -> a - b, "*", (a, b) -> a * b, "/", (a, b) -> a / b);

  private final String text;
  private final int deepest;
  private int at;
  private int depth;

  /**
   * For a text.
   *
   * @param text what is read
   * @param deepest how many parentheses and signs may stand within each other, as each is a call deeper
   */
  protected FormulaGrammar(String text, int deepest) {
    this.text = text;
    this.deepest = deepest;
  }

  /**
   * Reads a number, a name, a function: whatever is no sign and no parenthesis. What is read stands at {@link #at()}.
   *
   * @return what it is
   */
  protected abstract T operand();

  /**
   * Calculates with one part.
   *
   * @param function of {@link #ofOne}, or {@code -}
   * @param of what with
   * @return what it gives
   */
  protected abstract T one(String function, T of);

  /**
   * Calculates with two parts.
   *
   * @param function of {@link #ofTwo}, or a sign of {@code + - * /}
   * @param left the first
   * @param right the second
   * @return what it gives
   */
  protected abstract T two(String function, T left, T right);

  /**
   * Says that the text is no formula.
   *
   * @param missing what should stand at {@link #at()}, for example {@code )}
   * @return to be thrown
   */
  protected abstract RuntimeException wrong(String missing);

  /**
   * What a function of one number calculates.
   *
   * @param name abs sqrt sin cos tan asin acos atan floor round rad deg, or {@code -}
   * @return none where there is no such function
   */
  public static Optional<DoubleUnaryOperator> ofOne(String name) {
    return Optional.ofNullable(OF_ONE.get(name));
  }

  /**
   * What a function of two numbers calculates.
   *
   * @param name atan2 min max, or a sign of {@code + - * /}
   * @return none where there is no such function
   */
  public static Optional<DoubleBinaryOperator> ofTwo(String name) {
    return Optional.ofNullable(OF_TWO.get(name));
  }

  /**
   * Reads all of the text.
   *
   * @return the formula
   */
  protected final T whole() {
    T whole = sum();
    if (peek() != 0) {
      throw wrong("");
    }
    return whole;
  }

  /**
   * Reads a sum, as an argument of a function is one.
   *
   * @return the sum
   */
  protected final T sum() {
    T left = product();
    while (peek() == '+' || peek() == '-') {
      String sign = takes('-') || !takes('+') ? "-" : "+";
      left = two(sign, left, product());
    }
    return left;
  }

  private T product() {
    T left = factor();
    while (peek() == '*' || peek() == '/') {
      String sign = takes('/') || !takes('*') ? "/" : "*";
      left = two(sign, left, factor());
    }
    return left;
  }

  private T factor() {
    if (++depth > deepest) {
      throw new IllegalArgumentException("functions and parentheses are nested deeper than " + deepest);
    }
    T read = nested();
    depth--;
    return read;
  }

  private T nested() {
    if (takes('-')) {
      return one("-", factor());
    }
    if (takes('(')) {
      T inner = sum();
      needs(')');
      return inner;
    }
    return operand();
  }

  /**
   * Where the next character is read.
   *
   * @return from 0
   */
  protected final int at() {
    return at;
  }

  /**
   * Goes on elsewhere.
   *
   * @param next from 0 to the length of the text
   */
  protected final void at(int next) {
    at = next;
  }

  /**
   * What is read.
   *
   * @return all of it
   */
  protected final String text() {
    return text;
  }

  /**
   * Skips blanks.
   *
   * @return the next character, or 0 at the end
   */
  protected final char peek() {
    while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
      at++;
    }
    return at < text.length() ? text.charAt(at) : 0;
  }

  /**
   * Takes a character if it is the next one.
   *
   * @param wanted the character
   * @return whether it was there
   */
  protected final boolean takes(char wanted) {
    boolean there = peek() == wanted;
    at += there ? 1 : 0;
    return there;
  }

  /**
   * Takes a character that must stand there.
   *
   * @param wanted the character
   */
  protected final void needs(char wanted) {
    if (!takes(wanted)) {
      throw wrong(String.valueOf(wanted));
    }
  }

  /**
   * Takes what fits a pattern.
   *
   * @param pattern what is wanted
   * @return what stood there, or none
   */
  protected final Optional<String> takes(Pattern pattern) {
    peek();
    Matcher matcher = pattern.matcher(text).region(at, text.length());
    if (!matcher.lookingAt()) {
      return Optional.empty();
    }
    at = matcher.end();
    return Optional.of(matcher.group());
  }
}
