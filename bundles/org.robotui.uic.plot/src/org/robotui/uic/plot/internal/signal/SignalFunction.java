package org.robotui.uic.plot.internal.signal;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** A function of whole signals, which remembers samples, or of the parts of a field. */
enum SignalFunction {
  DERIVATIVE {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      return new Expr.Derivative(one(signals, numbers, 0, 0));
    }
  },
  INTEGRAL {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      return new Expr.Integral(one(signals, numbers, 0, 0));
    }
  },
  AVERAGE {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      return new Expr.Average(one(signals, numbers, 1, 1), numbers.getFirst());
    }

    @Override
    String also() {
      return " and the seconds over which to take the mean";
    }
  },
  LOWPASS {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      return new Expr.LowPass(one(signals, numbers, 1, 1), numbers.getFirst());
    }

    @Override
    String also() {
      return " and the limit in hertz";
    }
  },
  SCALE {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      return new Expr.Scale(one(signals, numbers, 1, 2), numbers.getFirst(), numbers.size() > 1 ? numbers.get(1) : 0);
    }

    @Override
    String also() {
      return ", a factor and, if wanted, an offset";
    }
  },
  DIFFERENCE {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      if (signals.size() != 2 || !numbers.isEmpty()) {
        throw new IllegalArgumentException("difference() takes two signals");
      }
      return new Expr.Difference(signals.get(0), signals.get(1));
    }
  },
  NORM {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      if (!numbers.isEmpty()) {
        throw new IllegalArgumentException("norm() takes signals only");
      }
      return new Expr.Norm(signals);
    }
  },
  ROLL {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      return angle(Expr.Turn.ROLL, signals, numbers);
    }
  },
  PITCH {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      return angle(Expr.Turn.PITCH, signals, numbers);
    }
  },
  YAW {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      return angle(Expr.Turn.YAW, signals, numbers);
    }
  },
  UNWRAP {
    @Override
    Expr of(List<Expr> signals, List<Double> numbers) {
      return new Expr.Unwrapped(one(signals, numbers, 0, 0));
    }
  };

  /** As users write them. */
  static final String NAMES = Arrays.stream(values()).map(SignalFunction::word).collect(Collectors.joining(", "));

  /** What it makes of its arguments. */
  abstract Expr of(List<Expr> signals, List<Double> numbers);

  /** What it takes beside one signal. */
  String also() {
    return "";
  }

  static Optional<SignalFunction> named(String word) {
    return Arrays.stream(values()).filter(f -> f.word().equals(word)).findFirst();
  }

  String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  Expr one(List<Expr> signals, List<Double> numbers, int least, int most) {
    if (signals.size() != 1 || numbers.size() < least || numbers.size() > most) {
      throw new IllegalArgumentException(word() + "() takes one signal" + also());
    }
    return signals.getFirst();
  }

  Expr angle(Expr.Turn turn, List<Expr> signals, List<Double> numbers) {
    if (one(signals, numbers, 0, 0) instanceof Expr.Field field) {
      return new Expr.Angle(turn, field);
    }
    throw new IllegalArgumentException(
        word() + "() takes an orientation, a field with x, y, z and w, for example base./odom:pose.rotation");
  }
}
