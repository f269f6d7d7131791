package org.robotui.headless.internal;

import java.io.PrintStream;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.host.CheckReport;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.Problem;
import org.robotui.api.host.ReuseReport;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;

/** Prints what becomes of a configuration: its problems, every connection, and why. */
final class CheckPrinter {
  private final PrintStream out;

  CheckPrinter(PrintStream out) {
    this.out = out;
  }

  void print(CheckReport report) {
    report.problems().forEach(p -> out.println(line(p)));
    report.matches().forEach(this::ruic);
    out.println(summary(report));
  }

  /**
   * What several RUICs share is said in a sentence; the whole matrix where it is asked for, as Markdown or
   * comma-separated values.
   */
  void reuse(ReuseReport report, Optional<String> format) {
    if (report.ruics().size() > 1 || format.isPresent()) {
      out.println(report.summary());
      new Differences(report).sentences().forEach(out::println);
    }
    format.ifPresent(f -> out.print("\n" + ("csv".equals(f) ? report.csv() : report.markdown())));
  }

  static String line(Problem problem) {
    String severity = problem.severity().name().toLowerCase(Locale.ROOT);
    String place = problem.line() == 0 ? "" : ":" + problem.line() + ":" + problem.column();
    return problem.file() + place + ": " + severity + ": " + problem.message();
  }

  private void ruic(String name, List<Match> matches) {
    out.println(name);
    int width = matches.stream().mapToInt(m -> subject(m).length()).max().orElse(0);
    matches.forEach(m -> out.println(match(m, width)));
  }

  private static String match(Match match, int width) {
    return String.format(Locale.ROOT, "  %-9s  %-" + Math.max(1, width) + "s  %s",
        word(match.state()), subject(match), detail(match)).stripTrailing();
  }

  private static String subject(Match match) {
    return match.port() + " (" + match.typeName() + ")";
  }

  private static String detail(Match match) {
    String peers = names(match.peers());
    String reason = match.reason();
    if (match.state() == MatchState.CONNECTED) {
      return arrow(match.kind()) + " " + peers + (reason.isEmpty() ? "" : " - " + reason);
    }
    boolean undecided = match.state() == MatchState.AMBIGUOUS && !match.candidates().isEmpty();
    return reason + (undecided ? " (candidates: " + names(match.candidates()) + ")" : "");
  }

  private static String arrow(PortKind kind) {
    return kind == PortKind.STREAM ? "<-" : "->";
  }

  static String names(List<SourceId> ids) {
    return ids.stream().map(SourceId::toString).collect(Collectors.joining(", "));
  }

  private static String summary(CheckReport report) {
    Map<MatchState, Long> counts = report.matches().values().stream()
        .flatMap(List::stream)
        .collect(Collectors.groupingBy(Match::state, () -> new EnumMap<>(MatchState.class), Collectors.counting()));
    String states = counts.entrySet().stream()
        .map(e -> e.getValue() + " " + word(e.getKey()))
        .collect(Collectors.joining(", "));
    return (states.isEmpty() ? "no connections" : states) + "; " + verdict(report);
  }

  private static String verdict(CheckReport report) {
    long errors = report.problems().stream().filter(p -> p.severity() == Problem.Severity.ERROR).count();
    long warnings = report.problems().size() - errors;
    return count(errors, "error") + ", " + count(warnings, "warning");
  }

  private static String count(long number, String noun) {
    return (number == 0 ? "no" : Long.toString(number)) + " " + noun + (number == 1 ? "" : "s");
  }

  static String word(MatchState state) {
    return state.name().toLowerCase(Locale.ROOT);
  }
}
