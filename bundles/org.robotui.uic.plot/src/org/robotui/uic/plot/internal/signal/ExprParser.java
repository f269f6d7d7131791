package org.robotui.uic.plot.internal.signal;

import java.util.ArrayList;
import java.util.List;
import org.robotui.api.input.TypedText;
import org.robotui.api.input.Unreadable;
import org.robotui.api.port.StreamField;

/**
 * Reads signals: {@code base./odom:twist.linear.x}, or a function of some:
 * {@code derivative(average(base./odom:x, 0.5))}.
 */
public final class ExprParser {
  static final String FUNCTIONS = "derivative, integral, average, scale, difference, norm";

  private static final int DEEPEST = 32;
  private static final int LONGEST = 4096;

  private final String text;
  private int at;

  private ExprParser(String text) {
    this.text = text;
  }

  /**
   * Reads a signal.
   *
   * @throws IllegalArgumentException where the text is none; the message says what is wrong, and what would do
   */
  public static Expr parse(String text) {
    if (text.length() > LONGEST) {
      throw new IllegalArgumentException("a signal has at most " + LONGEST + " characters");
    }
    ExprParser parser = new ExprParser(text);
    Expr result = parser.expression(0);
    if (parser.at < text.length()) {
      throw new IllegalArgumentException("'" + text.substring(parser.at).strip() + "' is left over after " + result);
    }
    return result;
  }

  private Expr expression(int depth) {
    if (depth > DEEPEST) {
      throw new IllegalArgumentException("functions are nested deeper than " + DEEPEST);
    }
    String word = word();
    return peek() == '(' ? call(word, depth) : field(word);
  }

  private Expr call(String function, int depth) {
    at++;
    List<Expr> signals = new ArrayList<>();
    List<Double> numbers = new ArrayList<>();
    while (true) {
      argument(function, signals, numbers, depth);
      char next = peek();
      at++;
      if (next == ')') {
        skipBlanks();
        return function(function, signals, numbers);
      }
      if (next != ',') {
        throw new IllegalArgumentException("the bracket of " + function + "( is not closed");
      }
    }
  }

  private void argument(String function, List<Expr> signals, List<Double> numbers, int depth) {
    int start = at;
    String word = word();
    if (word.isEmpty() || word.indexOf(':') >= 0 || peek() == '(') {
      at = start;
      signals.add(expression(depth + 1));
    } else if (signals.isEmpty()) {
      throw new IllegalArgumentException(
          "'" + word + "' in " + function + "() is no signal; write SOURCE:PATH, for example base./odom:linear.x");
    } else {
      numbers.add(number(word));
    }
  }

  private static double number(String word) {
    try {
      return TypedText.finite(word);
    } catch (Unreadable fault) {
      throw new IllegalArgumentException("'" + word + "' " + fault.getMessage(), fault);
    }
  }

  private static Expr function(String name, List<Expr> of, List<Double> numbers) {
    return switch (name) {
      case "derivative" -> new Expr.Derivative(one(name, of, numbers, 0, 0));
      case "integral" -> new Expr.Integral(one(name, of, numbers, 0, 0));
      case "average" -> new Expr.Average(one(name, of, numbers, 1, 1), numbers.getFirst());
      case "scale" -> new Expr.Scale(one(name, of, numbers, 1, 2), numbers.getFirst(),
          numbers.size() > 1 ? numbers.get(1) : 0);
      case "difference" -> difference(of, numbers);
      case "norm" -> norm(of, numbers);
      default -> throw new IllegalArgumentException("there is no function '" + name + "'; there are " + FUNCTIONS);
    };
  }

  private static Expr one(String name, List<Expr> of, List<Double> numbers, int least, int most) {
    if (of.size() != 1 || numbers.size() < least || numbers.size() > most) {
      throw new IllegalArgumentException(name + "() takes one signal"
          + switch (name) {
            case "average" -> " and the seconds over which to take the mean";
            case "scale" -> ", a factor and, if wanted, an offset";
            default -> "";
          });
    }
    return of.getFirst();
  }

  private static Expr difference(List<Expr> of, List<Double> numbers) {
    if (of.size() != 2 || !numbers.isEmpty()) {
      throw new IllegalArgumentException("difference() takes two signals");
    }
    return new Expr.Difference(of.get(0), of.get(1));
  }

  private static Expr norm(List<Expr> of, List<Double> numbers) {
    if (!numbers.isEmpty()) {
      throw new IllegalArgumentException("norm() takes signals only");
    }
    return new Expr.Norm(of);
  }

  private static Expr field(String word) {
    StreamField field = StreamField.read(word).orElseThrow(() -> new IllegalArgumentException(
        "'" + word + "' is no signal; write SOURCE:PATH, for example base./odom:linear.x, or a function of it"));
    return new Expr.Field(field.source(), field.path().toString());
  }

  private String word() {
    skipBlanks();
    int start = at;
    while (at < text.length() && "(),".indexOf(text.charAt(at)) < 0) {
      at++;
    }
    return text.substring(start, at).strip();
  }

  private void skipBlanks() {
    while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
      at++;
    }
  }

  private char peek() {
    return at < text.length() ? text.charAt(at) : '\0';
  }
}
