package org.robotui.api.replay;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robotui.api.replay.ComparisonReport.ComparedError;

/** Errors over time, and over the way gone where that is known. Immutable. */
public final class ErrorCurve {
  private static final int NANO_DIGITS = 9;

  private final long[] times;
  private final double[] gone;
  private final double[] errors;

  /**
   * Copies the arrays.
   *
   * @param times of the recording that is taken for right, nanoseconds since 1970, rising
   * @param gone how far its robot had gone at each time, metres; empty where that is not known
   * @param errors one for each time
   */
  public ErrorCurve(long[] times, double[] gone, double[] errors) {
    if (times.length != errors.length || gone.length != 0 && gone.length != times.length) {
      throw new IllegalArgumentException(times.length + " times, " + gone.length + " lengths of the way and "
          + errors.length + " errors");
    }
    this.times = times.clone();
    this.gone = gone.clone();
    this.errors = errors.clone();
  }

  /**
   * How many errors there are.
   *
   * @return the number
   */
  public int size() {
    return times.length;
  }

  /**
   * When an error was.
   *
   * @param index from 0
   * @return nanoseconds since 1970
   */
  public long time(int index) {
    return times[index];
  }

  /**
   * Whether the way gone is known.
   *
   * @return false for numbers
   */
  public boolean knowsWay() {
    return gone.length > 0;
  }

  /**
   * How far the robot had gone.
   *
   * @param index from 0
   * @return metres
   * @throws IndexOutOfBoundsException where that is not known
   */
  public double gone(int index) {
    return gone[index];
  }

  /**
   * An error.
   *
   * @param index from 0
   * @return in the unit of its kind
   */
  public double error(int index) {
    return errors[index];
  }

  /** A line for each time, a column for each kind of error. */
  static String csv(List<ComparedError> kinds) {
    boolean way = kinds.stream().anyMatch(kind -> kind.curve().knowsWay());
    Map<Long, List<String>> rows = new TreeMap<>();
    for (int kind = 0; kind < kinds.size(); kind++) {
      ErrorCurve curve = kinds.get(kind).curve();
      for (int i = 0; i < curve.size(); i++) {
        List<String> row = rows.computeIfAbsent(curve.time(i), time -> new ArrayList<>());
        if (way && row.isEmpty()) {
          row.add(Double.toString(curve.gone(i)));
        }
        while (row.size() < kind + (way ? 1 : 0)) {
          row.add("");
        }
        row.add(Double.toString(curve.error(i)));
      }
    }
    int columns = kinds.size() + (way ? 1 : 0);
    StringBuilder text = new StringBuilder("time [s]").append(way ? ",way [m]" : "");
    kinds.forEach(kind -> text.append(',').append(kind.title()));
    text.append('\n');
    rows.forEach((time, row) -> {
      text.append(BigDecimal.valueOf(time, NANO_DIGITS).toPlainString());
      for (int column = 0; column < columns; column++) {
        text.append(',').append(column < row.size() ? row.get(column) : "");
      }
      text.append('\n');
    });
    return text.toString();
  }
}
