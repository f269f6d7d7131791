package org.robotui.uic.plot.internal.signal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.api.input.FormulaGrammar;
import org.robotui.api.input.TypedText;
import org.robotui.api.input.Unreadable;
import org.robotui.api.port.StreamField;

/**
 * Reads signals: {@code base./odom:twist.linear.x}, a function of some, {@code derivative(average(base./odom:x, 0.5))},
 * or what is calculated of some, {@code 2 * base./odom:x + 1}.
 */
public final class ExprParser extends FormulaGrammar<Expr> {
  private static final int DEEPEST = 32;
  private static final int LONGEST = 4096;
  /** Not the beginning of a name, and not a number that is followed by one. */
  private static final Pattern FACTOR = Pattern.compile(NUMBER + "(?=\\s|[*/),]|$)");
  private static final Pattern SIGN_FOLLOWS = Pattern.compile("\\s+[-+*/](?:\\s|$)");
  private static final Pattern SIGN_INSIDE = Pattern.compile("[-+*/]");

  private final Function<String, Optional<Expr>> names;

  private ExprParser(String text, Function<String, Optional<Expr>> names) {
    super(text, DEEPEST);
    this.names = names;
  }

  /**
   * Reads a signal without names.
   *
   * @throws IllegalArgumentException where the text is none; the message says what is wrong and where, and what would
   * do
   */
  public static Expr parse(String text) {
    return parse(text, name -> Optional.empty());
  }

  /** Reads a signal, given what names mean. */
  public static Expr parse(String text, Function<String, Optional<Expr>> names) {
    if (text.length() > LONGEST) {
      throw new IllegalArgumentException("a signal has at most " + LONGEST + " characters");
    }
    Expr result = new ExprParser(text, names).whole();
    if (result.fields().findAny().isEmpty()) {
      throw new IllegalArgumentException("'" + text.strip() + "' is no signal, as it has no field; write SOURCE:PATH");
    }
    return result;
  }

  @Override
  protected IllegalArgumentException wrong(String missing) {
    String rest = text().substring(at()).strip();
    if (!missing.isEmpty()) {
      return at("a bracket is not closed: '" + missing + "' is missing"
          + (rest.isEmpty() ? " at the end" : " before '" + rest + "'"));
    }
    return at("'" + rest + "' is left over after '" + text().substring(0, at()).strip() + "'");
  }

  private IllegalArgumentException at(String reason) {
    return new IllegalArgumentException(reason + " (column " + (Math.min(at(), text().length()) + 1) + ")");
  }

  @Override
  protected Expr one(String function, Expr of) {
    return of instanceof Expr.Constant c
        ? new Expr.Constant(ofOne(function).orElseThrow().applyAsDouble(c.value()))
        : new Expr.Single(function, of);
  }

  @Override
  protected Expr two(String function, Expr left, Expr right) {
    return left instanceof Expr.Constant a && right instanceof Expr.Constant b
        ? new Expr.Constant(ofTwo(function).orElseThrow().applyAsDouble(a.value(), b.value()))
        : new Expr.Pairwise(function, left, right);
  }

  @Override
  protected Expr operand() {
    Optional<String> number = takes(FACTOR);
    if (number.isPresent()) {
      return new Expr.Constant(number(number.get()));
    }
    peek();
    int begin = at();
    String word = word();
    if (peek() == '(') {
      at(at() + 1);
      return call(word, begin);
    }
    int end = at();
    at(begin);
    Expr read = word.indexOf(':') < 0 ? named(word) : field(word);
    at(end);
    return read;
  }

  /** Up to a bracket, a comma, or a sign that stands between blanks: names of ports have signs in them. */
  private String word() {
    int start = at();
    int end = start;
    while (end < text().length() && "(),".indexOf(text().charAt(end)) < 0) {
      end++;
    }
    Matcher sign = SIGN_FOLLOWS.matcher(text()).region(start, end);
    end = sign.find() ? sign.start() : end;
    at(end);
    return text().substring(start, end).strip();
  }

  private Expr named(String word) {
    return names.apply(word).orElseThrow(() -> at("'" + word
        + "' is no signal; write SOURCE:PATH, for example base./odom:linear.x, or a function of it"));
  }

  private Expr field(String word) {
    try {
      StreamField field = StreamField.read(word).orElseThrow(() -> at(
          "'" + word + "' is no signal; write SOURCE:PATH, for example base./odom:linear.x, or a function of it"));
      return new Expr.Field(field.source(), field.path().toString());
    } catch (IllegalArgumentException e) {
      boolean signs = SIGN_INSIDE.matcher(word.substring(word.lastIndexOf(':') + 1)).find();
      throw signs ? at(e.getMessage() + "; write blanks around + - * /") : e;
    }
  }

  private double number(String word) {
    try {
      return TypedText.finite(word);
    } catch (Unreadable fault) {
      throw at("'" + word + "' " + fault.getMessage());
    }
  }

  private Expr call(String name, int begin) {
    List<Expr> signals = new ArrayList<>();
    List<Double> numbers = new ArrayList<>();
    do {
      argument(name, signals, numbers);
    } while (takes(','));
    needs(')');
    int end = at();
    at(begin);
    Expr read = SignalFunction.named(name).map(f -> f.of(signals, numbers)).or(() -> calculated(name, signals, numbers))
        .orElseThrow(() -> at("there is no function '" + name + "'; there are " + SignalFunction.NAMES
            + ", abs, sqrt, sin, cos, tan, asin, acos, atan, floor, round, rad, deg, atan2, min, max"));
    at(end);
    return read;
  }

  private void argument(String function, List<Expr> signals, List<Double> numbers) {
    peek();
    int begin = at();
    String word = word();
    boolean bare = peek() == ',' || peek() == ')';
    at(begin);
    if (bare && !signals.isEmpty() && word.indexOf(':') < 0 && names.apply(word).isEmpty()) {
      word();
      numbers.add(number(word));
      return;
    }
    Expr read = sum();
    if (read instanceof Expr.Constant c && signals.isEmpty() && ofTwo(function).isEmpty()) {
      at(begin);
      throw at("'" + c + "' in " + function
          + "() is no signal; write SOURCE:PATH, for example base./odom:linear.x");
    } else if (read instanceof Expr.Constant c) {
      numbers.add(c.value());
    } else {
      signals.add(read);
    }
  }

  /** Functions of numbers, one of two of which may be a constant. */
  private Optional<Expr> calculated(String name, List<Expr> signals, List<Double> numbers) {
    boolean letters = !name.isEmpty() && Character.isLetter(name.charAt(0));
    if (letters && ofOne(name).isPresent()) {
      if (signals.size() != 1 || !numbers.isEmpty()) {
        throw at(name + "() takes one signal");
      }
      return Optional.of(one(name, signals.getFirst()));
    }
    if (!letters || ofTwo(name).isEmpty()) {
      return Optional.empty();
    }
    if (signals.isEmpty() || signals.size() + numbers.size() != 2) {
      throw at(name.toLowerCase(Locale.ROOT) + "() takes two signals, or a signal and a number");
    }
    return Optional.of(two(name, signals.getFirst(),
        numbers.isEmpty() ? signals.get(1) : new Expr.Constant(numbers.getFirst())));
  }
}
