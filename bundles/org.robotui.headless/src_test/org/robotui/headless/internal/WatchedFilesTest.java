package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.ConfigChange.Step;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.ExchangePreview.Line;
import org.robotui.api.host.ExchangePreview.Verdict;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.Problem;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.host.FakeExchange;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakeRuic;

class WatchedFilesTest {
  private static final InterfaceConfig WANTED = new InterfaceConfig("base", "player", "a", "", Map.of());

  private final FakeExchange trial = new FakeExchange();
  private final FakeRuic ruic =
      new FakeRuic("a").exchanging(w -> trial, new InterfaceConfig("base", "ros", "a", "", Map.of()));
  private final FakeHost host = new FakeHost().add(ruic);
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private String told(String last, List<Problem> problems, Step... steps) {
    try (WatchedFiles files = new WatchedFiles(host, new PrintStream(err, true, StandardCharsets.UTF_8))) {
      host.tell(l -> l.configurationChanged(new ConfigChange(Path.of("a.yaml"), problems, List.of(steps))));
      long end = System.nanoTime() + 10_000_000_000L;
      while (!err.toString(StandardCharsets.UTF_8).contains(last)) {
        assertTrue(System.nanoTime() < end, () -> "waited in vain: " + err.toString(StandardCharsets.UTF_8));
        LockSupport.parkNanos(1_000_000);
      }
    }
    return err.toString(StandardCharsets.UTF_8);
  }

  private void says(Verdict verdict, boolean lost) {
    SourceId port = new SourceId("map", "scan");
    Match now = new Match(port, PortKind.STREAM, "LaserScan", Arity.ONE, MatchState.CONNECTED,
        List.of(new SourceId("base", "scan")), List.of(), "");
    Match then =
        new Match(port, PortKind.STREAM, "LaserScan", Arity.ONE, lost ? MatchState.REFUSED : MatchState.CONNECTED,
            lost ? List.of() : List.of(new SourceId("base", "laser:0")), List.of(), "so it is");
    trial.saying(new ExchangePreview(verdict, "map needs LaserScan", new LinkState.Connected("robot"),
        List.of(new Line(now, then, true, lost)), List.of(), List.of()));
  }

  @Test
  void whatCoversAllIsExchanged() {
    says(Verdict.READY, false);
    String told = told("exchanged", List.of(), new Step.Exchanged("a", WANTED));
    assertEquals(List.of("  connected  map.scan: base.scan -> base.laser:0 - so it is", "a.base as player: exchanged"),
        told.lines().toList());
    assertEquals(List.of("apply false", "close"), trial.calls());
  }

  @Test
  void whatDoesNotIsRefusedAndSaysWhatIsMissing() {
    says(Verdict.INCOMPLETE, true);
    String told = told("goes on", List.of(), new Step.Exchanged("a", WANTED));
    assertTrue(
        told.contains("lost       map.scan: base.scan -> ") && told.contains("not exchanged: map needs LaserScan"),
        told);
    assertEquals(List.of("close"), trial.calls());
  }

  @Test
  void goingBackIsSaid() {
    says(Verdict.READY, false);
    trial.ending(new ExchangeOutcome.WentBack("the robot has gone"));
    assertTrue(told("went back", List.of(), new Step.Exchanged("a", WANTED)).contains("went back: the robot has gone"));
  }

  @Test
  void mistakesAreSaidWithTheirPlace() {
    String told =
        told("goes on", List.of(new Problem("a.yaml", 3, 5, Problem.Severity.ERROR, "unknown setting 'per'")));
    assertTrue(told.contains("a.yaml:3:5: error: unknown setting 'per'"), told);
  }

  @Test
  void theRestIsTakenUpByARestart() {
    told("restarted", List.of(), new Step.NeedsRestart("a", "uics"));
    assertEquals(List.of("restart"), ruic.calls());
  }
}
