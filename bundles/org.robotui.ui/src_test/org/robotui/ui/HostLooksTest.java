package org.robotui.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;

class HostLooksTest {
  private static final SourceId PORT = new SourceId("base", "/scan");

  @Test
  void aLinkIsGreenOnlyWhenAllOfItWorks() {
    assertEquals(Health.OK, LinkLook.health(new LinkState.Connected("a:1")));
    assertEquals(Health.WARNING, LinkLook.health(new LinkState.Degraded("a:1", "wrong type")));
    assertEquals(Health.WAITING, LinkLook.health(new LinkState.Connecting("a:1")));
    assertEquals(Health.BAD, LinkLook.health(new LinkState.Failed("refused", Duration.ofSeconds(1))));
    assertEquals(Health.NONE, LinkLook.health(new LinkState.Disconnected()));
  }

  @Test
  void aComponentThatFailedSaysThatBeforeItsLink() {
    ComponentStatus failed = component(RuicState.FAILED, "fenced", Optional.of(new LinkState.Connected("a:1")));
    assertEquals(Health.BAD, LinkLook.health(failed));
    assertEquals("failed", LinkLook.word(failed));
    assertEquals("fenced", LinkLook.text(failed));
    ComponentStatus up = component(RuicState.SELECTED, "", Optional.of(new LinkState.Connected("a:1")));
    assertEquals("connected", LinkLook.word(up));
    assertEquals("a:1", LinkLook.text(up));
    assertEquals("base \u00b7 ros", LinkLook.name(up));
  }

  @Test
  void aPortThatNobodyWantsIsNotWaiting() {
    assertEquals(Health.NONE, PortLook.health(port(false, 0, 0, false, "")));
    assertEquals(Health.WAITING, PortLook.health(port(true, 0, 0, false, "")));
    assertEquals(Health.OK, PortLook.health(port(true, 5, 10, false, "")));
    assertEquals(Health.STALE, PortLook.health(port(true, 5, 10, true, "")));
    assertEquals(Health.BAD, PortLook.health(port(true, 0, 0, false, "wrong type")));
    assertEquals("10.0\u00a0Hz", PortLook.word(port(true, 5, 10, false, "")));
    assertEquals("event", PortLook.word(port(true, 1, 0, false, "")));
    assertEquals("wrong type", PortLook.text(port(true, 0, 0, false, "wrong type")));
    assertTrue(PortLook.details(port(false, 0, 0, false, "")).endsWith("no view uses it"));
    PortStatus promised =
        new PortStatus(PORT, PortKind.STREAM, "LaserScan", true, 0, 0, 0, false, 0, "", "", "reliable");
    assertTrue(PortLook.details(promised).endsWith("\nreliable"), PortLook.details(promised));
  }

  @Test
  void anOptionalPortWithoutAConnectionIsNoFault() {
    assertEquals(Health.NONE, MatchLook.health(match(Arity.OPTIONAL, MatchState.PENDING)));
    assertEquals(Health.WAITING, MatchLook.health(match(Arity.ONE, MatchState.PENDING)));
    assertEquals(Health.BAD, MatchLook.health(match(Arity.ONE, MatchState.REFUSED)));
    assertEquals(Health.WARNING, MatchLook.health(match(Arity.OPTIONAL, MatchState.AMBIGUOUS)));
    assertFalse(MatchLook.missing(match(Arity.ONE, MatchState.CONNECTED)));
    assertEquals("base./scan", MatchLook.text(match(Arity.ONE, MatchState.CONNECTED)));
    assertEquals("because", MatchLook.text(match(Arity.ONE, MatchState.REFUSED)));
  }

  private static ComponentStatus component(RuicState state, String reason, Optional<LinkState> link) {
    return new ComponentStatus("base", "ros", ComponentStatus.Kind.RFIC, state, reason, link);
  }

  private static PortStatus port(boolean wanted, long count, double rate, boolean stale, String problem) {
    return new PortStatus(PORT, PortKind.STREAM, "LaserScan", wanted, count, rate, 0.1, stale, 0, problem, "");
  }

  private static Match match(Arity arity, MatchState state) {
    return new Match(new SourceId("map", "scan"), PortKind.STREAM, "LaserScan", arity, state, List.of(PORT), List.of(),
        "because");
  }
}
