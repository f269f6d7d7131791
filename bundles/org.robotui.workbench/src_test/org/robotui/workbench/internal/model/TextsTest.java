package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.Principal;
import org.robotui.api.link.LinkState;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Health;

class TextsTest {
  private static final Principal YOU = new Principal("a", "You", Principal.Kind.WINDOW);
  private static final Principal BOB = new Principal("b", "Bob", Principal.Kind.WINDOW);

  private final FakeRuic ruic = new FakeRuic("Keira");

  @Test
  void theLeaseNamesItsHolder() {
    assertEquals(new Lease(Health.WAITING, "Nobody drives Keira"), lease());
    ruic.authority().take(YOU, false);
    assertEquals(new Lease(Health.OK, "You drive Keira"), lease());
    ruic.authority().take(BOB, true);
    assertEquals(new Lease(Health.WARNING, "Bob drives Keira"), lease());
  }

  @Test
  void aStopIsMoreThanALease() {
    ruic.authority().take(YOU, false);
    ruic.authority().stop(BOB);

    assertEquals(new Lease(Health.BAD, "Stopped by Bob"), lease());
  }

  @Test
  void whoHoldsTheLeaseOfARobotWithoutLinkDrivesNothing() {
    ruic.authority().take(YOU, false);
    ruic.linked(new LinkState.Failed("connection refused", Duration.ofSeconds(2)));
    assertEquals(new Lease(Health.WARNING, "No link to Keira"), lease());

    ruic.linked(new LinkState.Degraded("localhost", "slow"));
    assertEquals(new Lease(Health.WARNING, "You drive Keira"), lease());
  }

  @Test
  void withoutRobotThereIsNothingToDrive() {
    assertEquals(new Lease(Health.NONE, "Nothing to drive"), Lease.of(List.of(), new LinkState.Disconnected(), YOU));
  }

  @Test
  void theStatusNamesRobotClockAndTraffic() {
    assertEquals(new StatusText("Keira \u00b7 connected",
        "clock offset +3\u00a0ms \u00b7 received 0\u00a0msg/s \u00b7 dropped 0"), StatusText.of(ruic.snapshot(), ruic.clock()));
  }

  private Lease lease() {
    return Lease.of(ruic.authorities(), ruic.snapshot().link(), YOU);
  }
}
