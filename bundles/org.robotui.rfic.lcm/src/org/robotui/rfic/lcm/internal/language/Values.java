package org.robotui.rfic.lcm.internal.language;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmValue;
import org.robotui.lcm.type.NumberArray;

/**
 * The fields of one message, read as a mapping says. What is not there is said by an {@link IllegalArgumentException}.
 */
public final class Values {
  private static final double NANOS = 1e9;

  private final LcmRecord record;
  private final Map<String, Source> sources;

  /**
   * Of one message.
   *
   * @param record the message
   * @param sources where each field comes from, checked against its type
   */
  public Values(LcmRecord record, Map<String, Source> sources) {
    this.record = record;
    this.sources = sources;
  }

  /** Whether a field is mapped. */
  public boolean has(String field) {
    return sources.containsKey(field);
  }

  /** A number in SI units, or what to take where it is not mapped. */
  public double number(String field, double fallback) {
    return switch (sources.get(field)) {
      case null -> fallback;
      case Source.Constant c -> c.value();
      case Source.Member m -> m.factor() * plain(one(field, m));
      case Source other -> throw new IllegalStateException(field + " is no number: " + other);
    };
  }

  /** A whole number, or what to take where it is not mapped. */
  public int whole(String field, int fallback) {
    double number = number(field, fallback);
    if (number != (int) number) {
      throw new IllegalArgumentException(field + " must be a whole number below 2^31, is " + number);
    }
    return (int) number;
  }

  /** A truth value; false where it is not mapped. */
  public boolean flag(String field) {
    return number(field, 0) != 0;
  }

  /** Numbers in SI units; none where the field is not mapped. */
  public double[] numbers(String field) {
    return switch (sources.get(field)) {
      case null -> new double[0];
      case Source.Constant c -> new double[]{c.value()};
      case Source.Member m -> scaled(Collected.of(record, m.path()).numbers(), m.factor());
      case Source other -> throw new IllegalStateException(field + " are no numbers: " + other);
    };
  }

  private static double[] scaled(double[] numbers, double factor) {
    for (int i = 0; factor != 1 && i < numbers.length; i++) {
      numbers[i] *= factor;
    }
    return numbers;
  }

  /** How many things an array of numbers tells of, where several numbers tell of each: its outermost size. */
  public int rows(String field) {
    return sources.get(field) instanceof Source.Member m ? Collected.of(record, m.path()).rows() : 1;
  }

  /** The size of each dimension of an array; none where it is no plain array. */
  public List<Integer> shape(String field) {
    return array(field).map(NumberArray::shape).orElse(List.of());
  }

  /**
   * The array as it is in the message, its numbers not in SI units; none where the field is not mapped to an array as a
   * whole.
   */
  public Optional<NumberArray> array(String field) {
    return sources.get(field) instanceof Source.Member m && !m.path().isMany() ? record.numbers(m.path().toString())
        : Optional.empty();
  }

  /** What turns numbers of {@link #array} into SI units. */
  public double factor(String field) {
    return sources.get(field) instanceof Source.Member m ? m.factor() : 1;
  }

  /** The unit as written, empty where none is. */
  public String unit(String field) {
    return sources.get(field) instanceof Source.Member m ? m.unit() : "";
  }

  /** A text, or what to take where it is not mapped. Numbers are printed. */
  public String text(String field, String fallback) {
    return switch (sources.get(field)) {
      case null -> fallback;
      case Source.Words w -> w.texts().getFirst();
      case Source.Member m -> switch (one(field, m)) {
        case LcmValue.Text t -> t.value();
        case LcmValue.Whole w -> Long.toString(w.value());
        case LcmValue other -> Double.toString(plain(other));
      };
      case Source other -> throw new IllegalStateException(field + " is no text: " + other);
    };
  }

  /** Texts; none where the field is not mapped. */
  public List<String> texts(String field) {
    return switch (sources.get(field)) {
      case null -> List.of();
      case Source.Words w -> w.texts();
      case Source.Member m -> Collected.of(record, m.path()).texts();
      case Source other -> throw new IllegalStateException(field + " are no texts: " + other);
    };
  }

  /** A time in nanoseconds; none where it is not mapped. */
  public Optional<Long> nanos(String field) {
    if (!(sources.get(field) instanceof Source.Sum sum)) {
      return Optional.empty();
    }
    long nanos = 0;
    for (Source.Member part : sum.parts()) {
      long unit = Math.round(part.factor() * NANOS);
      nanos += switch (one(field, part)) {
        case LcmValue.Whole w -> Math.multiplyExact(w.value(), unit);
        case LcmValue other -> Math.round(plain(other) * unit);
      };
    }
    return Optional.of(nanos);
  }

  private LcmValue one(String field, Source.Member member) {
    return record.at(member.path().toString())
        .orElseThrow(() -> new IllegalArgumentException(field + ": this message has no " + member.path()));
  }

  private static double plain(LcmValue value) {
    return switch (value) {
      case LcmValue.Whole w -> w.value();
      case LcmValue.Real r -> r.value();
      case LcmValue.Flag f -> f.value() ? 1 : 0;
      case LcmValue other -> throw new IllegalStateException("no number: " + other);
    };
  }

  /** What a path with empty brackets leads to, all of it. */
  private record Collected(List<LcmValue> values, int rows) {
    static Collected of(LcmRecord record, MemberPath path) {
      List<LcmValue> at = List.of(new LcmValue.Nested(record));
      int rows = 1;
      StringBuilder part = new StringBuilder();
      for (MemberPath.Step step : path.steps()) {
        switch (step) {
          case MemberPath.Step.Name n -> part.append(part.isEmpty() ? "" : ".").append(n.name());
          case MemberPath.Step.Index i -> part.append('[').append(i.index()).append(']');
          case MemberPath.Step.All all -> {
            List<LcmValue> here = follow(at, part.toString());
            at = here.stream().flatMap(v -> v instanceof LcmValue.Records r
                ? r.values().stream().<LcmValue>map(LcmValue.Nested::new)
                : Stream.of(v)).toList();
            rows = at.size() == 1 && at.getFirst() instanceof LcmValue.Numbers n ? n.value().size() : at.size();
            part.setLength(0);
          }
        }
      }
      List<LcmValue> values = part.isEmpty() ? at : follow(at, part.toString());
      boolean whole = !path.isMany() && values.size() == 1 && values.getFirst() instanceof LcmValue.Numbers;
      return new Collected(values, whole ? outermost(((LcmValue.Numbers) values.getFirst()).value()) : rows);
    }

    private static int outermost(NumberArray array) {
      return array.shape().size() > 1 ? array.shape().getFirst() : 1;
    }

    private static List<LcmValue> follow(List<LcmValue> from, String path) {
      List<LcmValue> found = new ArrayList<>(from.size());
      for (LcmValue value : from) {
        found.add(((LcmValue.Nested) value).value().at(path)
            .orElseThrow(() -> new IllegalArgumentException("this message has no " + path)));
      }
      return found;
    }

    double[] numbers() {
      if (values.size() == 1 && values.getFirst() instanceof LcmValue.Numbers(NumberArray array)) {
        return array.toDoubles();
      }
      return values.stream().flatMapToDouble(v -> v instanceof LcmValue.Numbers(NumberArray array)
          ? Arrays.stream(array.toDoubles())
          : DoubleStream.of(plain(v))).toArray();
    }

    List<String> texts() {
      List<String> texts = new ArrayList<>();
      for (LcmValue value : values) {
        switch (value) {
          case LcmValue.Text t -> texts.add(t.value());
          case LcmValue.Texts t -> texts.addAll(t.values());
          case LcmValue other -> throw new IllegalStateException("no text: " + other);
        }
      }
      return texts;
    }
  }
}
