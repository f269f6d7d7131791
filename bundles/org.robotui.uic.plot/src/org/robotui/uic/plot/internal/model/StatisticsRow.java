package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robotui.api.input.Numerals;
import org.robotui.uic.plot.internal.trace.Statistics;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * The statistics of a trace in words.
 *
 * @param ref which trace
 * @param name with its unit
 * @param of the numbers
 */
public record StatisticsRow(TraceRef ref, String name, Statistics of) {
  /** A column of the table. */
  public record Figure(String title, Function<StatisticsRow, String> text, Function<StatisticsRow, Double> number) {}

  /** From left to right, behind the name. */
  public static final List<Figure> FIGURES = List.of(
      new Figure("Samples", row -> Long.toString(row.of.count()), row -> (double) row.of.count()),
      figure("Minimum", Statistics::min), figure("Maximum", Statistics::max), figure("Mean", Statistics::mean),
      figure("Std. deviation", Statistics::deviation), figure("Rate [Hz]", Statistics::rate));

  private static Figure figure(String title, Function<Statistics, Double> number) {
    return new Figure(title, row -> words(number.apply(row.of)), row -> number.apply(row.of));
  }

  private static String words(double number) {
    return Double.isNaN(number) ? "\u2013" : Readout.of(number);
  }

  /** Of all traces that are drawn. */
  public static List<StatisticsRow> of(PlotScene scene, SpanOfAxis spans) {
    return IntStream.range(0, scene.axes().size()).boxed().flatMap(axis -> rows(scene, axis, spans)).toList();
  }

  /** What of the time is meant. */
  @FunctionalInterface
  public interface SpanOfAxis {
    TimeSpan of(int axis);
  }

  private static Stream<StatisticsRow> rows(PlotScene scene, int axis, SpanOfAxis spans) {
    List<TraceView> traces = scene.axes().get(axis);
    return IntStream.range(0, traces.size()).filter(i -> traces.get(i).drawn())
        .mapToObj(i -> new StatisticsRow(new TraceRef(axis, i), name(traces.get(i)),
            traces.get(i).series().orElseThrow().statistics(spans.of(axis))));
  }

  private static String name(TraceView trace) {
    return trace.unit().isEmpty() ? trace.label() : trace.label() + " [" + trace.unit() + "]";
  }

  /** All of the table with its headings, as spreadsheets take it: with all digits. */
  public static String table(List<StatisticsRow> rows) {
    String head = "Trace\t" + FIGURES.stream().map(Figure::title).collect(Collectors.joining("\t"));
    return Stream.concat(Stream.of(head), rows.stream().map(StatisticsRow::line)).collect(Collectors.joining("\n"));
  }

  private String line() {
    return name + "\t" + of.count() + FIGURES.stream().skip(1).map(f -> "\t" + digits(f.number().apply(this)))
        .collect(Collectors.joining());
  }

  private static String digits(double number) {
    return Double.isNaN(number) ? "" : Numerals.text(number);
  }
}
