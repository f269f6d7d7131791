package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.robotui.uic.plot.internal.signal.Expr;

/** The units of what is computed of fields. */
public final class Units {
  private static final String RADIAN = "rad";
  private static final String DEGREE = "\u00b0";
  private static final String SECOND = "s";
  private static final String PER_SECOND = "/s";
  private static final String SQUARED = "\u00b2";

  private Units() {}

  /** The unit of a signal, from those of its fields; empty where none is known. */
  public static String of(Expr expr, Function<Expr.Field, String> known) {
    return switch (expr) {
      case Expr.Field f -> known.apply(f);
      case Expr.Derivative d -> perSecond(of(d.of(), known));
      case Expr.Integral i -> timesSecond(of(i.of(), known));
      case Expr.Average a -> of(a.of(), known);
      case Expr.Scale s -> s.factor() == 1 ? of(s.of(), known) : "";
      case Expr.Difference d -> common(List.of(d.of(), d.less()), known);
      case Expr.Constant c -> "";
      case Expr.Single s -> single(s.function(), of(s.of(), known));
      case Expr.Pairwise p -> pairwise(p, known);
      case Expr.Angle a -> RADIAN;
      case Expr.Unwrapped u -> of(u.of(), known);
      case Expr.LowPass l -> of(l.of(), known);
      case Expr.Named n -> n.unit().orElseGet(() -> of(n.of(), known));
      case Expr.Over o -> of(o.of(), known);
      case Expr.Norm n -> common(n.of(), known);
    };
  }

  private static String single(String function, String unit) {
    return switch (function) {
      case "-", "abs", "floor", "round" -> unit;
      case "deg" -> unit.isEmpty() || unit.equals(RADIAN) ? DEGREE : unit.replace(RADIAN, DEGREE);
      case "rad", "asin", "acos", "atan" -> RADIAN;
      default -> "";
    };
  }

  /** Sums have the unit of their parts; products of units are left to users. */
  private static String pairwise(Expr.Pairwise pair, Function<Expr.Field, String> known) {
    List<Expr> parts = Stream.of(pair.left(), pair.right()).filter(e -> !(e instanceof Expr.Constant)).toList();
    return switch (pair.function()) {
      case "+", "-", "min", "max" -> common(parts, known);
      case "atan2" -> RADIAN;
      default -> "";
    };
  }

  private static String common(List<Expr> of, Function<Expr.Field, String> known) {
    List<String> units = of.stream().map(e -> of(e, known)).distinct().toList();
    return units.size() == 1 ? units.getFirst() : "";
  }

  private static String perSecond(String unit) {
    if (unit.endsWith(PER_SECOND)) {
      return unit + SQUARED;
    }
    if (unit.equals(SECOND)) {
      return "";
    }
    return unit.isEmpty() || unit.endsWith(SQUARED) ? "" : unit + PER_SECOND;
  }

  private static String timesSecond(String unit) {
    if (unit.endsWith(PER_SECOND + SQUARED)) {
      return unit.substring(0, unit.length() - 1);
    }
    if (unit.endsWith(PER_SECOND)) {
      return unit.substring(0, unit.length() - PER_SECOND.length());
    }
    return unit.isEmpty() ? "" : unit + "\u00b7s";
  }
}
