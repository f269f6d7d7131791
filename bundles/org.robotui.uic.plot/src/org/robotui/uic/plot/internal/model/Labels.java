package org.robotui.uic.plot.internal.model;

import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.robotui.api.input.Numerals;
import org.robotui.uic.plot.internal.signal.Expr;

/** Short names of signals: paths and signs instead of sources and functions. */
public final class Labels {
  private static final Map<String, String> SIGNS = Map.of("+", "+", "-", "\u2212", "*", "\u00b7", "/", "/");

  private Labels() {}

  public static String of(Expr expr) {
    return switch (expr) {
      case Expr.Field f -> f.path();
      case Expr.Derivative d -> "d/dt " + inner(d.of());
      case Expr.Integral i -> "\u222b " + inner(i.of());
      case Expr.Average a -> "mean " + Numerals.text(a.seconds()) + "\u00a0s " + inner(a.of());
      case Expr.Scale s -> scale(s);
      case Expr.Difference d -> inner(d.of()) + " \u2212 " + inner(d.less());
      case Expr.Constant c -> c.toString();
      case Expr.Single s -> s.function().equals("-") ? "\u2212" + inner(s.of()) : s.function() + " " + inner(s.of());
      case Expr.Pairwise p when p.isSign() -> part(p, p.left(), false) + " " + SIGNS.get(p.function()) + " "
          + part(p, p.right(), true);
      case Expr.Pairwise p -> p.function() + "(" + of(p.left()) + ", " + of(p.right()) + ")";
      case Expr.Angle a -> a.turn().name().toLowerCase(Locale.ROOT) + " " + a.of().path();
      case Expr.Unwrapped u -> of(u.of());
      case Expr.LowPass l -> "<" + Numerals.text(l.hertz()) + "\u00a0Hz " + inner(l.of());
      case Expr.Named n -> n.name();
      case Expr.Over o -> of(o.of());
      case Expr.Norm n -> n.of().stream().map(Labels::of).collect(Collectors.joining(", ", "|", "|"));
    };
  }

  /** The sources, each once: {@code base./odom, base./cmd_vel}. */
  public static String sources(Expr expr) {
    return expr.fields().map(f -> f.source().toString()).distinct().collect(Collectors.joining(", "));
  }

  private static String scale(Expr.Scale s) {
    String factor = s.factor() == 1 ? inner(s.of()) : inner(s.of()) + " \u00b7 " + Numerals.text(s.factor());
    if (s.offset() == 0) {
      return factor;
    }
    return factor + (s.offset() < 0 ? " \u2212 " : " + ") + Numerals.text(Math.abs(s.offset()));
  }

  private static String part(Expr.Pairwise whole, Expr part, boolean isRight) {
    boolean close = part instanceof Expr.Pairwise || part instanceof Expr.Single one && one.function().equals("-");
    return close && !whole.brackets(part, isRight) ? of(part) : inner(part);
  }

  private static String inner(Expr expr) {
    boolean simple = expr instanceof Expr.Field || expr instanceof Expr.Norm || expr instanceof Expr.Constant
        || expr instanceof Expr.Named;
    return simple ? of(expr) : "(" + of(expr) + ")";
  }
}
