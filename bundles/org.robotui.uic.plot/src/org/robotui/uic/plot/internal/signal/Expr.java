package org.robotui.uic.plot.internal.signal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.input.FormulaGrammar;
import org.robotui.api.input.Numerals;
import org.robotui.api.port.SourceId;

/**
 * What a trace shows: a field of a source, or what is computed of one. Its text is what {@link ExprParser} reads, and
 * two that mean the same have the same text.
 */
public sealed interface Expr {
  /** The fields it is computed of, in the order of the text. */
  Stream<Field> fields();

  /** A field of the values of a source. */
  record Field(SourceId source, String path) implements Expr {
    @Override
    public Stream<Field> fields() {
      return Stream.of(this);
    }

    @Override
    public String toString() {
      return source + ":" + path;
    }
  }

  /** The change per second. */
  record Derivative(Expr of) implements Expr {
    @Override
    public Stream<Field> fields() {
      return of.fields();
    }

    @Override
    public String toString() {
      return "derivative(" + of + ")";
    }
  }

  /** The area below the curve since its first sample. */
  record Integral(Expr of) implements Expr {
    @Override
    public Stream<Field> fields() {
      return of.fields();
    }

    @Override
    public String toString() {
      return "integral(" + of + ")";
    }
  }

  /** The mean of the last seconds. */
  record Average(Expr of, double seconds) implements Expr {
    public Average {
      if (!(seconds > 0) || seconds > 3600) {
        throw new IllegalArgumentException(
            "an average is taken over more than 0 and at most 3600 seconds, not " + seconds);
      }
    }

    @Override
    public Stream<Field> fields() {
      return of.fields();
    }

    @Override
    public String toString() {
      return "average(" + of + ", " + Numerals.text(seconds) + ")";
    }
  }

  /** Times a factor, plus an offset. */
  record Scale(Expr of, double factor, double offset) implements Expr {
    public Scale {
      if (!Double.isFinite(factor) || !Double.isFinite(offset)) {
        throw new IllegalArgumentException("factor and offset of a scale must be finite");
      }
    }

    @Override
    public Stream<Field> fields() {
      return of.fields();
    }

    @Override
    public String toString() {
      return "scale(" + of + ", " + Numerals.text(factor) + (offset == 0 ? "" : ", " + Numerals.text(offset)) + ")";
    }
  }

  /** One less another, at the times of the first. */
  record Difference(Expr of, Expr less) implements Expr {
    @Override
    public Stream<Field> fields() {
      return Stream.concat(of.fields(), less.fields());
    }

    @Override
    public String toString() {
      return "difference(" + of + ", " + less + ")";
    }
  }

  /** A number, within what is calculated. */
  record Constant(double value) implements Expr {
    @Override
    public Stream<Field> fields() {
      return Stream.empty();
    }

    @Override
    public String toString() {
      return Numerals.text(value);
    }
  }

  /** What a function of one number makes of each sample, by its name as {@link FormulaGrammar#ofOne} has it. */
  record Single(String function, Expr of) implements Expr {
    @Override
    public Stream<Field> fields() {
      return of.fields();
    }

    @Override
    public String toString() {
      boolean loose =
          of instanceof Pairwise pair && pair.isSign() || of instanceof Single one && one.function.equals("-");
      return !function.equals("-") ? function + "(" + of + ")" : loose ? "-(" + of + ")" : "-" + of;
    }
  }

  /** What a function or sign makes of two, as {@link FormulaGrammar#ofTwo} has it, at the times of the first. */
  record Pairwise(String function, Expr left, Expr right) implements Expr {
    @Override
    public Stream<Field> fields() {
      return Stream.concat(left.fields(), right.fields());
    }

    /** Whether it is written between both. */
    public boolean isSign() {
      return !Character.isLetter(function.charAt(0));
    }

    /** Whether a part of it must stand in brackets: what binds no closer than its sign. */
    public boolean brackets(Expr part, boolean isRight) {
      boolean sum = part instanceof Pairwise p && (p.function.equals("+") || p.function.equals("-"));
      boolean product = part instanceof Pairwise p && (p.function.equals("*") || p.function.equals("/"));
      boolean isProduct = function.equals("*") || function.equals("/");
      boolean minus = part instanceof Single one && one.function.equals("-");
      return isProduct && sum || isRight && (sum || isProduct && product || minus);
    }

    private String part(Expr part, boolean isRight) {
      return brackets(part, isRight) ? "(" + part + ")" : part.toString();
    }

    @Override
    public String toString() {
      return isSign() ? part(left, false) + " " + function + " " + part(right, true)
          : function + "(" + left + ", " + right + ")";
    }
  }

  /** An angle of an orientation, a field with the parts x, y, z and w. */
  record Angle(Turn turn, Field of) implements Expr {
    @Override
    public Stream<Field> fields() {
      return Stream.of("x", "y", "z", "w").map(part -> new Field(of.source(), of.path() + "." + part));
    }

    @Override
    public String toString() {
      return turn.name().toLowerCase(Locale.ROOT) + "(" + of + ")";
    }
  }

  /** About which axis: x, y, z of the turned frame. */
  enum Turn {
    ROLL, PITCH, YAW
  }

  /** An angle that goes on where it would jump by a whole turn. */
  record Unwrapped(Expr of) implements Expr {
    @Override
    public Stream<Field> fields() {
      return of.fields();
    }

    @Override
    public String toString() {
      return "unwrap(" + of + ")";
    }
  }

  /** What changes slower than so many times a second. */
  record LowPass(Expr of, double hertz) implements Expr {
    public LowPass {
      if (!(hertz > 0) || hertz > 1e6) {
        throw new IllegalArgumentException(
            "a low-pass has a limit of more than 0 and at most 1000000 Hz, not " + hertz);
      }
    }

    @Override
    public Stream<Field> fields() {
      return of.fields();
    }

    @Override
    public String toString() {
      return "lowpass(" + of + ", " + Numerals.text(hertz) + ")";
    }
  }

  /** One that the plot has a name for; its unit, where the plot says it. */
  record Named(String name, Optional<String> unit, Expr of) implements Expr {
    @Override
    public Stream<Field> fields() {
      return of.fields();
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** One over another: the points of a curve, at the times of the first. */
  record Over(Expr of, Expr x) implements Expr {
    @Override
    public Stream<Field> fields() {
      return Stream.concat(of.fields(), x.fields());
    }

    @Override
    public String toString() {
      return of + " over " + x;
    }
  }

  /** The length of the vector of several, at the times of the first. */
  record Norm(List<Expr> of) implements Expr {
    public Norm {
      of = List.copyOf(of);
      if (of.isEmpty()) {
        throw new IllegalArgumentException("a norm needs at least one signal");
      }
    }

    @Override
    public Stream<Field> fields() {
      return of.stream().flatMap(Expr::fields);
    }

    @Override
    public String toString() {
      return of.stream().map(Expr::toString).collect(Collectors.joining(", ", "norm(", ")"));
    }
  }
}
