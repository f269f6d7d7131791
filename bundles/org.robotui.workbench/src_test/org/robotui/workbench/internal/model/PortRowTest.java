package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Health;

class PortRowTest {
  private final FakeRuic ruic = new FakeRuic("Keira");

  @Test
  void wantedComeBeforeMissingBeforeUnwanted() {
    ruic.offering(port("/tf", false, 5, 1, false, ""), port("/scan", true, 10, 0.012, false, ""))
        .matching(missing("image", Arity.ONE, MatchState.PENDING));

    assertEquals(List.of("scan", "camera.image", "tf"), rows().stream().map(PortRow::name).toList());
  }

  @Test
  void portsOfSeveralInterfacesSayWhoseTheyAre() {
    ruic.offering(port("natalie", "scan"), port("otto", "scan"));

    assertEquals(List.of("natalie.scan", "otto.scan"), rows().stream().map(PortRow::name).toList());
  }

  @Test
  void statesDifferInWordAndDot() {
    ruic.offering(port("a", true, 10, 0.012, false, ""), port("b", true, 10, 2.1, true, "no new value"),
        port("c", true, 0, Double.NaN, false, ""), port("d", true, 10, 0.1, false, "wrong type"));

    assertEquals(List.of("10.0\u00a0Hz", "stale 2.1\u00a0s", "waiting", "failed"),
        rows().stream().map(PortRow::figure).toList());
    assertEquals(List.of("12\u00a0ms", "", "", ""), rows().stream().map(PortRow::age).toList());
    assertEquals(List.of(Health.OK, Health.STALE, Health.WAITING, Health.BAD),
        rows().stream().map(PortRow::health).toList());
  }

  @Test
  void anUndecidedConnectionAsksForAChoiceAndSaysWhy() {
    ruic.matching(missing("image", Arity.ONE, MatchState.AMBIGUOUS));

    assertEquals("choose one", rows().getFirst().figure());
    assertTrue(rows().getFirst().hint().endsWith("because"));
  }

  @Test
  void whatAViewCanDoWithoutIsNotMissed() {
    ruic.matching(missing("image", Arity.OPTIONAL, MatchState.PENDING));

    assertEquals(List.of(), rows());
  }

  @Test
  void ofThousandsThatNobodyLooksAtTheFirstStandForAll() {
    ruic.offering(IntStream.range(0, 2000).mapToObj(i -> port("t" + i, i < 3, 0, Double.NaN, false, ""))
        .toArray(PortStatus[]::new));

    assertEquals(3 + 40 + 1, rows().size());
    assertEquals("and 1957 more", rows().getLast().name());
  }

  private List<PortRow> rows() {
    return PortRow.of(ruic.snapshot());
  }

  private static Match missing(String port, Arity arity, MatchState state) {
    return new Match(new SourceId("camera", port), PortKind.STREAM, "Image", arity, state, List.of(), List.of(),
        "because");
  }

  private static PortStatus port(String component, String name) {
    return new PortStatus(new SourceId(component, name), PortKind.STREAM, "Data", true, 9, 10, 0.012, false, 0, "", "");
  }

  private static PortStatus port(String name, boolean wanted, double rate, double age, boolean stale, String problem) {
    return new PortStatus(new SourceId("base", name), PortKind.STREAM, "Data", wanted, Double.isNaN(age) ? 0 : 9, rate,
        age,
        stale, 0, problem, "");
  }
}
