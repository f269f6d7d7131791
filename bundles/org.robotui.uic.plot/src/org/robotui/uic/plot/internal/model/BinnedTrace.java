package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robotui.api.input.Numerals;

/**
 * The values of a trace, counted.
 *
 * @param trace which
 * @param bins its values
 */
public record BinnedTrace(TraceView trace, ValueBins bins) {
  /** Lines for files and spreadsheets: a heading, and a row for each bin of each trace, with all digits. */
  public static String table(List<BinnedTrace> all, String separator) {
    String head = String.join(separator, "trace", "unit", "from", "to", "count", "share") + "\n";
    return all.stream().flatMap(each -> each.rows(separator)).collect(Collectors.joining("", head, ""));
  }

  private Stream<String> rows(String separator) {
    return IntStream.range(0, bins.counts().size()).mapToObj(bin -> String.join(separator,
        CsvExport.quoted(trace.spec().signal()), CsvExport.quoted(trace.unit()), Numerals.text(bins.edge(bin)),
        Numerals.text(bins.edge(bin + 1)), Long.toString(bins.counts().get(bin)),
        Numerals.text((double) bins.counts().get(bin) / bins.samples())) + "\n");
  }
}
