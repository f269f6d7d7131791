package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.CheckReport;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.Problem;
import org.robotui.api.host.ReuseReport;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;

class CheckPrinterTest {
  private static final SourceId FRONT = new SourceId("base", "front");
  private static final SourceId REAR = new SourceId("base", "rear");

  @Test
  void printsEveryConnectionAndWhy() {
    List<Match> matches = List.of(
        match("scan", PortKind.STREAM, MatchState.CONNECTED, List.of(FRONT), List.of(), ""),
        match("goal", PortKind.COMMAND, MatchState.REFUSED, List.of(), List.of(), "base takes no goal"),
        match("odom", PortKind.STREAM, MatchState.AMBIGUOUS, List.of(), List.of(FRONT, REAR), "two fit"),
        match("map", PortKind.STREAM, MatchState.PENDING, List.of(), List.of(), "base may offer it when it runs"));

    assertEquals(List.of(
        "natalie",
        "  connected  map.scan (Data)  <- base.front",
        "  refused    map.goal (Data)  base takes no goal",
        "  ambiguous  map.odom (Data)  two fit (candidates: base.front, base.rear)",
        "  pending    map.map (Data)   base may offer it when it runs",
        "1 connected, 1 refused, 1 pending, 1 ambiguous; no errors, no warnings"),
        print(new CheckReport(List.of(), Map.of("natalie", matches), ReuseReport.EMPTY)));
  }

  @Test
  void problemsNameTheirPlace() {
    Problem problem = new Problem("ros.yaml", 3, 5, Problem.Severity.ERROR, "unknown word 'veiws', write 'views'");

    assertEquals(List.of("ros.yaml:3:5: error: unknown word 'veiws', write 'views'",
        "no connections; 1 error, no warnings"), print(new CheckReport(List.of(problem), Map.of(), ReuseReport.EMPTY)));
  }

  @Test
  void robotUisOfOneTypeDifferByWhatSpeaksToTheirRobots() {
    List<String> both = List.of("Natalie", "Keira");
    ReuseReport.Row type = row(ReuseReport.Kind.RUIC, "ruic.mobilebase", both);
    ReuseReport.Row map = row(ReuseReport.Kind.UIC, "uic.map", both);
    ReuseReport.Row ros = row(ReuseReport.Kind.RFIC, "rfic.ros", List.of("Natalie", "Team"));
    ReuseReport.Row gps = row(ReuseReport.Kind.UIC, "uic.gps", List.of("Keira"));

    assertEquals("Natalie and Keira differ only by rfic.ros: none of them is a view", differences(type, map, ros));
    assertEquals("Natalie and Keira differ only by rfic.ros, uic.gps", differences(type, map, ros, gps));
    assertEquals("Natalie and Keira use the same bundles", differences(type, map));
  }

  private static ReuseReport.Row row(ReuseReport.Kind kind, String bundle, List<String> users) {
    return new ReuseReport.Row(kind, bundle, bundle, users);
  }

  private static String differences(ReuseReport.Row... rows) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    new CheckPrinter(new PrintStream(bytes, true, StandardCharsets.UTF_8))
        .reuse(new ReuseReport(List.of("Natalie", "Keira", "Team"), List.of(rows)), Optional.empty());
    return bytes.toString(StandardCharsets.UTF_8).lines().toList().getLast();
  }

  private static Match match(
      String port, PortKind kind, MatchState state, List<SourceId> peers, List<SourceId> candidates, String why) {
    return new Match(new SourceId("map", port), kind, "Data", Arity.ONE, state, peers, candidates, why);
  }

  private static List<String> print(CheckReport report) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    new CheckPrinter(new PrintStream(bytes, true, StandardCharsets.UTF_8)).print(report);
    return bytes.toString(StandardCharsets.UTF_8).lines().toList();
  }
}
