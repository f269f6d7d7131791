package org.robotui.condition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import org.robotui.api.input.Numerals;
import org.robotui.data.record.FieldPath;
import org.robotui.condition.ConditionWords.Piece;
import org.robotui.condition.Term.Yields;

/** Reads conditions that combine several, by recursive descent: or, and, not, comparison, sum, product, value. */
final class ConditionParser {
  private static final int MOST_DEPTH = 40;

  private final ConditionWords words;
  private int depth;

  ConditionParser(ConditionWords words) {
    this.words = words;
  }

  /**
   * Reads all of it.
   *
   * @throws IllegalArgumentException where it cannot be read; the message names the column, and says what was expected
   */
  Term parse() {
    Term claim = claim(this::either);
    if (!words.atEnd()) {
      throw words.wrong("here 'and', 'or' or the end was expected");
    }
    return claim;
  }

  private interface Part {
    Term parse();
  }

  /** A part that must hold or not. */
  private Term claim(Part part) {
    Piece first = words.next();
    Term term = part.parse();
    if (term.yields() != Yields.TRUTH && term.yields() != Yields.ANY) {
      throw words.wrong(first, "that is a value and no condition; compare it, as in battery charge < 0.2");
    }
    return term;
  }

  private Term either() {
    Piece first = words.next();
    Term left = both();
    while (words.next().is("or")) {
      truth(first, left);
      words.take();
      left = new Claim.Both(false, left, claim(this::both));
    }
    return left;
  }

  private Term both() {
    Piece first = words.next();
    Term left = not();
    while (words.next().is("and")) {
      truth(first, left);
      words.take();
      left = new Claim.Both(true, left, claim(this::not));
    }
    return left;
  }

  private void truth(Piece first, Term left) {
    if (left.yields() != Yields.TRUTH && left.yields() != Yields.ANY) {
      throw words.wrong(first, "that is a value and no condition; compare it before '" + words.next().text() + "'");
    }
  }

  private Term not() {
    return deeper(() -> words.take("not") ? new Claim.Turned(claim(this::not)) : comparison());
  }

  private Term deeper(Part part) {
    if (++depth > MOST_DEPTH) {
      throw words.wrong("it is nested too deeply");
    }
    Term term = part.parse();
    depth--;
    return term;
  }

  private Term comparison() {
    Term left = sum();
    Optional<Comparison> sign = words.next().comparison();
    if (sign.isEmpty()) {
      return left;
    }
    Piece at = words.take();
    Term right = words.next().quoted() || isWord() ? word() : sum();
    boolean words = left.yields() == Yields.WORD || right.yields() == Yields.WORD;
    if (words && sign.get().ordered()) {
      throw this.words.wrong(at, "a word has no order; compare it by == or !=");
    }
    return new Claim.Compared(sign.get(), left, right);
  }

  /** After a comparison, one word alone is a word of the robot's: two are a source and a field. */
  private boolean isWord() {
    Piece next = words.next();
    return isName(next) && Numerals.decimal(next.text()).isEmpty() && !isName(words.ahead(1)) && !isCall();
  }

  private Term word() {
    if (words.atEnd()) {
      throw words.wrong("here a value was expected");
    }
    Piece word = words.take();
    boolean flag = word.is("true") || word.is("false");
    return new Term.Written(flag ? new Operand.Truth(word.is("true")) : new Operand.Word(word.text()));
  }

  private Term sum() {
    Term left = product();
    while (words.next().is("+") || words.next().is("-")) {
      boolean plus = words.take().is("+");
      left = binary(plus ? Double::sum : (a, b) -> a - b, left, product());
    }
    return left;
  }

  private Term product() {
    Term left = value();
    while (words.next().is("*") || words.next().is("/")) {
      boolean times = words.take().is("*");
      left = binary(times ? (a, b) -> a * b : (a, b) -> a / b, left, value());
    }
    return left;
  }

  private Term binary(DoubleBinaryOperator operator, Term left, Term right) {
    if (isNoNumber(left) || isNoNumber(right)) {
      throw words.wrong("before this one counts with what is no number");
    }
    return new Term.Binary(operator, left, right);
  }

  private static boolean isNoNumber(Term term) {
    return term.yields() != Yields.NUMBER && term.yields() != Yields.ANY;
  }

  private Term value() {
    Piece next = words.next();
    if (words.take("(")) {
      Term inside = either();
      words.require(")");
      return inside;
    }
    if (words.take("-")) {
      return new Term.Unary(a -> -a, deeper(this::value));
    }
    if (isCall()) {
      return call();
    }
    Optional<Double> number = next.quoted() ? Optional.empty() : Numerals.decimal(next.text());
    if (number.isPresent()) {
      words.take();
      return new Term.Written(new Operand.Number(number.get(), next.text()));
    }
    return named();
  }

  private boolean isCall() {
    return isName(words.next()) && words.ahead(1).is("(");
  }

  private Term call() {
    Piece name = words.take();
    words.require("(");
    Term called = switch (name.text()) {
      case "age" -> new Pace(Pace.Measure.AGE, source());
      case "rate" -> new Pace(Pace.Measure.RATE, source());
      case "delay" -> new Pace(Pace.Measure.DELAY, source());
      case "abs" -> new Term.Unary(Math::abs, sum());
      case "min" -> folded(Math::min);
      case "max" -> folded(Math::max);
      default -> throw words.wrong(name,
          "there is age(SOURCE), rate(SOURCE), delay(SOURCE), abs(X), min(X, Y) and max(X, Y)");
    };
    words.require(")");
    return called;
  }

  private Term folded(DoubleBinaryOperator operator) {
    Term all = sum();
    while (words.take(",")) {
      all = binary(operator, all, sum());
    }
    return all;
  }

  private SourceName source() {
    if (words.atEnd() || words.next().is(")")) {
      throw words.wrong("here the name of a source was expected, such as scan");
    }
    return new SourceName(words.take().text());
  }

  /** What begins with a name: one of the plain conditions, or a source and a field. */
  private Term named() {
    if (words.atEnd() || !(words.next().quoted() || isName(words.next()))) {
      throw words.wrong("here a source and a field, a number, 'not' or '(' was expected");
    }
    Piece first = words.next();
    if (first.is("true") || first.is("false")) {
      return word();
    }
    if (first.is("log")) {
      throw words.wrong("an entry of a log does not last, so that it cannot be combined; give it an alert of its own");
    }
    Optional<Condition> plain = plain();
    return plain.<Term>map(Claim.Plain::new).orElseGet(this::field);
  }

  /** The plain conditions that last. */
  private Optional<Condition> plain() {
    List<String> taken = new ArrayList<>();
    int signs = 0;
    if (words.ahead(1).is("stale") || words.next().is("link") && words.ahead(1).is("lost")) {
      taken.add(words.take().text());
      taken.add(words.take().text());
    } else if (words.next().is("diagnostics")) {
      signs = words.ahead(1).comparison().isPresent() ? 1 : words.ahead(2).comparison().isPresent() ? 2 : 0;
      boolean level = signs > 0 && Conditions.isLevel(words.ahead(signs + 1).text());
      for (int i = 0; level && i < signs + 2; i++) {
        Piece piece = words.take();
        taken.add(piece.comparison().isPresent() ? piece.text() : "\"" + piece.text() + "\"");
      }
    }
    return taken.isEmpty() ? Optional.empty() : Optional.of(Conditions.parse(String.join(" ", taken), 0));
  }

  private Term field() {
    Piece source = words.take();
    if (source.text().startsWith("-")) {
      throw words.wrong(source, "before a source there is a blank behind the minus");
    }
    if (words.atEnd() || !(words.next().quoted() || isName(words.next()))) {
      throw words.wrong(source, "behind a source its field is missing; write for example battery charge");
    }
    Piece field = words.take();
    if (field.is("changes") || words.next().is("changes")) {
      throw words.wrong("a change does not last, so that it cannot be combined; write it alone");
    }
    try {
      return new Term.Field(new SourceName(source.text()), FieldPath.parse(field.text()));
    } catch (IllegalArgumentException e) {
      throw words.wrong(field, e.getMessage());
    }
  }

  /** What can be a name: no sign, and none of our own words. */
  private static boolean isName(Piece piece) {
    return !piece.quoted() && piece.text().matches("[^<>=!()+*,]+") && !piece.is("-") && !piece.is("/")
        && !piece.is("and") && !piece.is("or") && !piece.is("not");
  }
}
