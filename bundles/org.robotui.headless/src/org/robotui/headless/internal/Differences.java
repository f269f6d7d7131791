package org.robotui.headless.internal;

import java.util.HashSet;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.host.ReuseReport;

/** By which bundles robot UIs of one type differ, which should be those that speak to the robots. */
record Differences(ReuseReport report) {
  /** A sentence for each type that several robot UIs have. */
  Stream<String> sentences() {
    return report.rows().stream().filter(row -> row.kind() == ReuseReport.Kind.RUIC && row.users().size() > 1)
        .map(type -> sentence(type.users()));
  }

  private String sentence(List<String> users) {
    String names = String.join(", ", users.subList(0, users.size() - 1)) + " and " + users.getLast();
    List<ReuseReport.Row> rows = report.rows().stream().filter(row -> isBetween(row, users)).toList();
    boolean views = rows.stream()
        .anyMatch(row -> row.kind() == ReuseReport.Kind.UIC || row.kind() == ReuseReport.Kind.ENTITY);
    return rows.isEmpty() ? names + " use the same bundles"
        : names + " differ only by " + rows.stream().map(ReuseReport.Row::bundle).collect(Collectors.joining(", "))
            + (views ? "" : ": none of them is a view");
  }

  private static boolean isBetween(ReuseReport.Row row, List<String> users) {
    HashSet<String> with = new HashSet<>(users);
    with.retainAll(row.users());
    return !with.isEmpty() && with.size() < users.size();
  }
}
