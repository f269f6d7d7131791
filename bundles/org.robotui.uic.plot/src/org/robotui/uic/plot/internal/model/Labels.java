package org.robotui.uic.plot.internal.model;

import java.util.stream.Collectors;
import org.robotui.api.input.Numerals;
import org.robotui.uic.plot.internal.signal.Expr;

/** Short names of signals: paths and signs instead of sources and functions. */
public final class Labels {
  private Labels() {}

  public static String of(Expr expr) {
    return switch (expr) {
      case Expr.Field f -> f.path();
      case Expr.Derivative d -> "d/dt " + inner(d.of());
      case Expr.Integral i -> "\u222b " + inner(i.of());
      case Expr.Average a -> "mean " + Numerals.text(a.seconds()) + "\u00a0s " + inner(a.of());
      case Expr.Scale s -> scale(s);
      case Expr.Difference d -> inner(d.of()) + " \u2212 " + inner(d.less());
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

  private static String inner(Expr expr) {
    boolean simple = expr instanceof Expr.Field || expr instanceof Expr.Norm;
    return simple ? of(expr) : "(" + of(expr) + ")";
  }
}
