package org.robotui.uic.connections.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeStatus.Counts;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Health;

class BridgeLineTest {
  private static final BridgeEnd FROM = new BridgeEnd("Natalie", new SourceId("base", "scan"));
  private static final BridgeEnd TO = new BridgeEnd("Keira", new SourceId("base", "far/scan"));

  private static BridgeStatus status(State state, String text, long dropped) {
    return new BridgeStatus("scan", FROM, TO, state, text, new Counts(3, 2, 0, dropped, 1), 10, 0.0012,
        Optional.of("Anna"));
  }

  @Test
  void itIsListedAtBothEnds() {
    BridgeStatus status = status(State.CARRYING, "carrying", 0);
    BridgeLine here = new BridgeLine(FROM, status);
    BridgeLine there = new BridgeLine(TO, status);
    assertEquals("scan \u2192 Keira", here.name());
    assertEquals("far/scan \u2190 Natalie", there.name());
    assertEquals("Natalie", here.ruic());
    assertNotEquals(here.key(), there.key());
    assertEquals(Health.OK, here.health());
    assertFalse(here.isProblem());
    assertTrue(here.text().contains("Hz, lag"), here.text());
    assertTrue(here.text().endsWith("far/scan"), here.text());
    assertTrue(here.details().contains("Natalie.base.scan \u2192 Keira.base.far/scan"), here.details());
    assertTrue(here.details().contains("3 received, 2 passed, 0 thinned, 0 dropped, 1 refused"), here.details());
    assertTrue(here.details().endsWith("Anna has control"), here.details());
  }

  @Test
  void whatIsWrongIsAProblemWithItsReason() {
    BridgeLine refused = new BridgeLine(FROM, status(State.REFUSED, "Keira is stopped", 0));
    assertEquals("Keira is stopped", refused.text());
    assertTrue(refused.isProblem());
    assertEquals(Health.BAD, new BridgeLine(FROM, status(State.WRONG, "no transform", 0)).health());
    assertTrue(new BridgeLine(FROM, status(State.CARRYING, "carrying", 4)).isProblem());
    assertEquals("4", new BridgeLine(FROM, status(State.CARRYING, "carrying", 4)).dropped());
  }
}
