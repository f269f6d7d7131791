package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Health;

class RobotRowTest {
  private final FakeRuic ruic = new FakeRuic("Keira").linked(new LinkState.Connected("http://localhost:11411/"))
      .component(
          new ComponentStatus("base", "ros", ComponentStatus.Kind.RFIC, RuicState.INITIALIZED, "", Optional.empty()));

  @Test
  void showsTheRateOfTheBusiestPortThatAViewWants() {
    ruic.offering(port("scan", true, 10, false), port("odom", true, 49.6, false), port("imu", false, 200, false));

    assertEquals(new RobotRow("Keira", Health.OK, "50\u00a0Hz", "ros \u00b7 :11411"), row());
  }

  @Test
  void staleDataIsMoreThanARate() {
    ruic.offering(port("scan", true, 10, true), port("odom", true, 50, false));

    assertEquals("1 stale", row().figure());
    assertEquals(Health.STALE, row().health());
  }

  @Test
  void connectedWithoutDataIsNotGreen() {
    ruic.offering(port("scan", true, 0, false));

    assertEquals("no data", row().figure());
    assertEquals(Health.WAITING, row().health());
  }

  @Test
  void aBrokenLinkSaysWhenItTriesAgain() {
    ruic.linked(new LinkState.Failed("no master at :11311", Duration.ofSeconds(4)));

    assertEquals(new RobotRow("Keira", Health.BAD, "retry 4 s", "ros \u00b7 no master at :11311"), row());
  }

  @Test
  void aFailedComponentIsAWarning() {
    ruic.offering(port("scan", true, 10, false)).fail("camera", "not installed");

    assertEquals(Health.WARNING, row().health());
  }

  @Test
  void whatWaitsToBeShownIsNotDisconnected() {
    ruic.linked(new LinkState.Disconnected()).in(RuicState.ADDED, "");

    assertEquals(new RobotRow("Keira", Health.NONE, "not open", "ros"), row());
  }

  @Test
  void aFailedRuicSaysWhy() {
    ruic.in(RuicState.FAILED, "the type is not installed");

    assertEquals(new RobotRow("Keira", Health.BAD, "failed", "the type is not installed"), row());
  }

  @Test
  void peersAreShortWhereTheyAreHere() {
    assertEquals(":11411", RobotRow.shortened("http://127.0.0.1:11411/"));
    assertEquals("robot:11311", RobotRow.shortened("http://robot:11311"));
    assertEquals("10.0.0.7:6665", RobotRow.shortened("10.0.0.7:6665"));
  }

  private RobotRow row() {
    return RobotRow.of(ruic.snapshot());
  }

  private static PortStatus port(String name, boolean wanted, double rate, boolean stale) {
    return new PortStatus(new SourceId("base", name), PortKind.STREAM, "Data", wanted, rate > 0 ? 9 : 0, rate, 0.1,
        stale,
        0, "", "");
  }
}
