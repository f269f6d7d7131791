package org.robotui.uic.plot.internal.signal;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import org.robotui.api.input.FormulaGrammar;
import org.robotui.geometry.Quaternion;

/**
 * What computes a signal sample by sample. To begin anew after a time jump, make a new one. One thread.
 *
 * @param inputs where the samples of each field go in, in the order of {@link Expr#fields()}
 */
public record Pipeline(List<Input> inputs) {
  private static final int PARTS = 4;

  /** Where the samples of a field go in. */
  public record Input(Expr.Field field, Sink sink) {}

  public Pipeline {
    inputs = List.copyOf(inputs);
  }

  public static Pipeline of(Expr expr, Sink out) {
    List<Input> inputs = new ArrayList<>();
    build(expr, out, inputs);
    return new Pipeline(inputs);
  }

  /** Of a curve, both signals of which are computed. */
  public static Pipeline of(Expr.Over curve, PairSink out) {
    List<Input> inputs = new ArrayList<>();
    join(List.of(curve.of(), curve.x()), new JoinNode(2, (time, v) -> out.accept(time, v[1], v[0])), inputs);
    return new Pipeline(inputs);
  }

  private static void build(Expr expr, Sink out, List<Input> inputs) {
    switch (expr) {
      case Expr.Field f -> inputs.add(new Input(f, out));
      case Expr.Derivative d -> build(d.of(), new DerivativeNode(out), inputs);
      case Expr.Integral i -> build(i.of(), new IntegralNode(out), inputs);
      case Expr.Average a -> build(a.of(), new AverageNode(a.seconds(), out), inputs);
      case Expr.Scale s -> build(s.of(), (time, value) -> out.accept(time, value * s.factor() + s.offset()), inputs);
      case Expr.Difference d -> join(List.of(d.of(), d.less()),
          new JoinNode(2, (time, v) -> out.accept(time, v[0] - v[1])), inputs);
      case Expr.Norm n -> join(n.of(), new JoinNode(n.of().size(), (time, v) -> out.accept(time, norm(v))), inputs);
      case Expr.Constant c -> throw new IllegalArgumentException("a signal needs a field");
      case Expr.Single s -> build(s.of(), single(s, out), inputs);
      case Expr.Pairwise p -> pairwise(p, out, inputs);
      case Expr.Angle a -> join(a.fields().<Expr>map(f -> f).toList(),
          new JoinNode(PARTS, (time, v) -> out.accept(time, angle(a.turn(), v))), inputs);
      case Expr.Unwrapped u -> build(u.of(), new UnwrapNode(out), inputs);
      case Expr.LowPass l -> build(l.of(), new LowPassNode(l.hertz(), out), inputs);
      case Expr.Named n -> build(n.of(), out, inputs);
      case Expr.Over o -> inputs.addAll(of(o, (time, x, y) -> out.accept(time, y)).inputs());
    }
  }

  private static Sink single(Expr.Single single, Sink out) {
    DoubleUnaryOperator by = FormulaGrammar.ofOne(single.function()).orElseThrow();
    return (time, value) -> out.accept(time, by.applyAsDouble(value));
  }

  private static void pairwise(Expr.Pairwise pair, Sink out, List<Input> inputs) {
    DoubleBinaryOperator by = FormulaGrammar.ofTwo(pair.function()).orElseThrow();
    if (pair.left() instanceof Expr.Constant c) {
      build(pair.right(), (time, value) -> out.accept(time, by.applyAsDouble(c.value(), value)), inputs);
    } else if (pair.right() instanceof Expr.Constant c) {
      build(pair.left(), (time, value) -> out.accept(time, by.applyAsDouble(value, c.value())), inputs);
    } else {
      join(List.of(pair.left(), pair.right()),
          new JoinNode(2, (time, v) -> out.accept(time, by.applyAsDouble(v[0], v[1]))), inputs);
    }
  }

  /** A rotation that was never set (all 0) is none. */
  private static double angle(Expr.Turn turn, double[] xyzw) {
    Quaternion given = new Quaternion(xyzw[0], xyzw[1], xyzw[2], xyzw[3]);
    double norm = given.norm();
    if (!(norm > 0) || !Double.isFinite(norm)) {
      return Double.NaN;
    }
    Quaternion rotation = given.normalized();
    return switch (turn) {
      case ROLL -> rotation.roll();
      case PITCH -> rotation.pitch();
      case YAW -> rotation.yaw();
    };
  }

  private static void join(List<Expr> of, JoinNode node, List<Input> inputs) {
    for (int i = 0; i < of.size(); i++) {
      build(of.get(i), node.input(i), inputs);
    }
  }

  private static double norm(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value * value;
    }
    return Math.sqrt(sum);
  }
}
