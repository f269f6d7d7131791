package org.robotui.uic.plot.internal.model;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.stream.Stream;
import org.robotui.api.input.Numerals;
import org.robotui.uic.plot.internal.trace.Curve;
import org.robotui.uic.plot.internal.trace.Samples;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * Writes samples as comma separated values: a column for the time in seconds and one for each trace, merged by time;
 * what a trace does not have at a time stays empty. Numbers are written the same in all languages, exact to the last
 * digit.
 */
public final class CsvExport {
  /** A trace to write. */
  public record Column(String name, String unit, Samples samples) {
    /** Those of a trace: one, or what a curve is drawn over and the curve. */
    public static Stream<Column> of(TraceView trace) {
      if (trace.over().isEmpty()) {
        return Stream.of(new Column(trace.spec().signal(), trace.unit(), trace.series().orElseThrow().samples()));
      }
      CurveView over = trace.over().get();
      Curve.Both both = over.curve().samples();
      return Stream.of(new Column(over.signal(), over.unit(), both.x()),
          new Column(trace.spec().signal(), trace.unit(), both.y()));
    }
  }

  private static final int DIGITS = 9;
  private static final int LOOK_EVERY = 1 << 12;

  private final List<Column> columns;
  private final TimeSpan span;
  private final int[] at;

  public CsvExport(List<Column> columns, TimeSpan span) {
    this.columns = List.copyOf(columns);
    this.span = span;
    this.at = columns.stream().mapToInt(c -> c.samples().indexOf(span.from())).toArray();
  }

  /**
   * Writes all.
   *
   * @return how many rows
   * @throws IOException where it cannot be written, or where the thread was interrupted
   */
  public long write(Writer out) throws IOException {
    out.write(header());
    StringBuilder row = new StringBuilder();
    long rows = 0;
    for (long time = next(); time != Long.MAX_VALUE; time = next()) {
      row.setLength(0);
      if (row(time, row)) {
        out.append(row);
        rows++;
      }
      if (rows % LOOK_EVERY == 0 && Thread.currentThread().isInterrupted()) {
        throw new IOException("interrupted");
      }
    }
    return rows;
  }

  private String header() {
    StringBuilder header = new StringBuilder("time [s]");
    for (Column column : columns) {
      header.append(',')
          .append(quoted(column.unit().isEmpty() ? column.name() : column.name() + " [" + column.unit() + "]"));
    }
    return header.append('\n').toString();
  }

  private long next() {
    long next = Long.MAX_VALUE;
    for (int i = 0; i < at.length; i++) {
      Samples samples = columns.get(i).samples();
      if (at[i] < samples.size() && samples.time(at[i]) <= span.to()) {
        next = Math.min(next, samples.time(at[i]));
      }
    }
    return next;
  }

  /** False where nothing was there but breaks. */
  private boolean row(long time, StringBuilder row) {
    row.append(seconds(time));
    boolean any = false;
    for (int i = 0; i < at.length; i++) {
      row.append(',');
      Samples samples = columns.get(i).samples();
      if (at[i] < samples.size() && samples.time(at[i]) == time) {
        double value = samples.value(at[i]++);
        any |= !Double.isNaN(value);
        row.append(Double.isNaN(value) ? "" : Numerals.text(value));
      }
    }
    row.append('\n');
    return any;
  }

  static String seconds(long nanos) {
    long size = Math.abs(nanos);
    String part = Long.toString(size % TimeSpan.SECOND);
    return (nanos < 0 ? "-" : "") + size / TimeSpan.SECOND + "." + "0".repeat(DIGITS - part.length()) + part;
  }

  /** As a field of such a line. */
  static String quoted(String text) {
    return text.indexOf(',') < 0 && text.indexOf('"') < 0 ? text : '"' + text.replace("\"", "\"\"") + '"';
  }
}
