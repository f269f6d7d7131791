package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.Principal;
import org.robotui.api.link.LinkState;
import org.robotui.api.time.RobotClock;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Health;

class TextsTest {
  private static final Principal YOU = new Principal("a", "You", Principal.Kind.WINDOW);
  private static final Principal BOB = new Principal("b", "Bob", Principal.Kind.WINDOW);

  private final FakeRuic ruic = new FakeRuic("Keira");

  @Test
  void theLeaseNamesItsHolder() {
    assertEquals(new Lease(Health.WAITING, "Nobody controls Keira"), lease());
    ruic.authority().take(YOU, false);
    assertEquals(new Lease(Health.OK, "You control Keira"), lease());
    ruic.authority().take(BOB, true);
    assertEquals(new Lease(Health.WARNING, "Bob controls Keira"), lease());
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
    assertEquals(new Lease(Health.WARNING, "You control Keira"), lease());
  }

  @Test
  void ofSeveralRobotsTheLeaseCountsThoseThatSomebodyControls() {
    List<FakeAuthority> all = List.of(new FakeAuthority("r1"), new FakeAuthority("r2"), new FakeAuthority("r3"));
    assertEquals(new Lease(Health.WAITING, "Nobody controls a robot"), several(all));
    all.get(1).take(BOB, false);
    assertEquals(new Lease(Health.WARNING, "Bob controls r2"), several(all));
    all.get(2).take(YOU, false);
    assertEquals(new Lease(Health.OK, "You control r3"), several(all));
    all.get(0).take(YOU, false);
    assertEquals(new Lease(Health.OK, "You control 2 of 3 robots"), several(all));
    all.get(1).take(YOU, true);
    assertEquals(new Lease(Health.OK, "You control all 3 robots"), several(all));
    all.get(1).stop(BOB);
    assertEquals(new Lease(Health.BAD, "Stopped by Bob"), several(all));
  }

  private static Lease several(List<FakeAuthority> all) {
    return Lease.of(List.copyOf(all), new LinkState.Connected("localhost"), YOU);
  }

  @Test
  void withoutRobotThereIsNothingToDrive() {
    assertEquals(new Lease(Health.NONE, "Nothing to drive"), Lease.of(List.of(), new LinkState.Disconnected(), YOU));
  }

  @Test
  void theStatusNamesRobotClockAndTraffic() {
    assertEquals(new StatusText("Keira \u00b7 connected",
        "clock offset +3\u00a0ms \u00b7 received 0\u00a0msg/s \u00b7 dropped 0"),
        StatusText.of(ruic.snapshot(), ruic.clock()));
  }

  @Test
  void stampsThatNoRunningClockGivesAreNamedAsSuch() {
    assertTrue(right(Duration.ofHours(-182_679)).startsWith("time stamps 7611 days old: a recording? "),
        right(Duration.ofHours(-182_679)));
    assertTrue(right(Duration.ofDays(30)).startsWith("time stamps 30 days ahead: "));
    assertTrue(right(Duration.ofHours(-3)).startsWith("clock offset "), "a wrong time zone is an offset");
  }

  private String right(Duration offset) {
    RobotClock clock = new RobotClock() {
      @Override
      public Stamp now() {
        return new Stamp(0, ClockKind.WALL);
      }

      @Override
      public ClockKind kind() {
        return ClockKind.WALL;
      }

      @Override
      public Optional<Duration> offset() {
        return Optional.of(offset);
      }

      @Override
      public long epoch() {
        return 0;
      }
    };
    return StatusText.of(ruic.snapshot(), clock).right();
  }

  private Lease lease() {
    return Lease.of(ruic.authorities(), ruic.snapshot().link(), YOU);
  }
}
