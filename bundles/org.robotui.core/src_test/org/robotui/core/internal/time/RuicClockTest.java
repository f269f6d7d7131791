package org.robotui.core.internal.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.robotui.api.time.ClockSource;
import org.robotui.core.internal.support.ManualClock;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;

class RuicClockTest {
  private static final long EPOCH = 1_700_000_000_000_000_000L;
  private static final long MILLI = 1_000_000;

  private final ManualClock mono = new ManualClock();
  private final WallClock wall = () -> EPOCH + mono.nanos();
  private final AtomicInteger jumps = new AtomicInteger();
  private final RuicClock clock = new RuicClock(mono, wall, jumps::incrementAndGet);
  private final ClockSource source = clock.source("base");

  @Test
  void withoutStampsItIsTheWallClock() {
    assertEquals(new Stamp(wall.nanos(), ClockKind.WALL), clock.now());
    assertEquals(Optional.empty(), clock.offset());
    assertEquals(0, clock.epoch());
  }

  @Test
  void offsetIsEstimatedThroughVaryingDelay() {
    Random random = new Random(2);
    long ahead = 3_000 * MILLI;
    for (int i = 0; i < 500; i++) {
      mono.advanceMillis(20);
      long delay = MILLI + (long) (random.nextDouble() * 80 * MILLI);
      source.observed(wall.nanos() + ahead - delay);
    }
    assertEquals(3000, clock.offset().orElseThrow().toMillis(), 3);
    assertEquals(ClockKind.ROBOT, clock.kind());
    assertEquals(wall.nanos() + clock.offset().orElseThrow().toNanos(), clock.now().nanos());
  }

  @Test
  void offsetFollowsAClockThatWasSetWithinAMinute() {
    source.observed(wall.nanos() + 5000 * MILLI);
    for (int i = 0; i < 70; i++) {
      mono.advanceMillis(1000);
      source.observed(wall.nanos() + 1000 * MILLI);
    }
    assertEquals(Duration.ofSeconds(1), clock.offset().orElseThrow());
  }

  @Test
  void offsetIsKeptWhileTheRobotIsSilent() {
    source.observed(wall.nanos() + 5000 * MILLI);
    mono.advanceMillis(3_600_000);
    assertEquals(Duration.ofSeconds(5), clock.offset().orElseThrow());
  }

  @Test
  void simulatedTimeStandsStillBetweenItsMessages() {
    source.simulated(7_000 * MILLI);
    mono.advanceMillis(500);
    assertEquals(new Stamp(7_000 * MILLI, ClockKind.SIMULATED), clock.now());
    assertEquals(0, clock.epoch(), "the first simulated time is no jump");
  }

  @Test
  void simulatedTimeThatJumpsBackStartsAnEpoch() {
    source.simulated(7_000 * MILLI);
    source.simulated(8_000 * MILLI);
    source.simulated(7_995 * MILLI);
    assertEquals(0, clock.epoch(), "two publishers out of step are no jump");
    assertEquals(8_000 * MILLI, clock.now().nanos());
    source.simulated(0);
    assertEquals(1, clock.epoch());
    assertEquals(1, jumps.get());
    assertEquals(0, clock.now().nanos());
  }

  @Test
  void changesBetweenSimulatedAndLiveAreJumps() {
    source.observed(wall.nanos());
    source.simulated(0);
    assertEquals(1, clock.epoch());
    source.live();
    assertEquals(2, clock.epoch());
    assertEquals(ClockKind.WALL, clock.kind());
    source.live();
    assertEquals(2, clock.epoch());
  }

  @Test
  void simulatedInterfaceCountsAmongSeveral() {
    ClockSource second = clock.source("other");
    source.observed(wall.nanos() + MILLI);
    second.simulated(5);
    assertEquals(ClockKind.SIMULATED, clock.kind());
    clock.source("other");
    assertEquals(ClockKind.ROBOT, clock.kind(), "a new instance starts anew");
    assertTrue(clock.offset().isPresent());
  }

  @Test
  void aRecordingThatIsMovedBeginsAnewInBothDirectionsAndValuesGrowOldByItsTime() {
    RobotTime played = clock.source("recording");
    played.replayed(5000 * MILLI);
    assertEquals(0, clock.epoch());
    long opened = mono.nanos();
    mono.advanceMillis(60_000);
    assertEquals(5000 * MILLI, played.nanos(), "it stands still");
    assertEquals(5000 * MILLI, played.at(mono.nanos() - 10 * MILLI));
    assertEquals(4990 * MILLI, played.at(opened - 10 * MILLI));
    played.moved(9000 * MILLI);
    assertEquals(1, clock.epoch());
    assertEquals(new Stamp(9000 * MILLI, ClockKind.SIMULATED), clock.now());
    played.moved(1000 * MILLI);
    played.replayed(1500 * MILLI);
    assertEquals(2, clock.epoch());
    assertEquals(2, jumps.get());
    assertEquals(1500 * MILLI, played.nanos());
    played.live();
    assertEquals(mono.nanos(), played.nanos());
  }

  private double age(long receivedNanos) {
    return clock.ageSeconds(receivedNanos, mono.nanos());
  }

  @Test
  void agesAreThoseOfARecordingWhereverAValueWasReceivedInIt() {
    RobotTime played = clock.source("recording");
    long first = mono.nanos();
    assertEquals(0, age(first));
    mono.advanceMillis(500);
    assertEquals(0.5, age(first), 1e-9, "by this machine where nothing is played");

    played.replayed(5000 * MILLI);
    long begin = mono.nanos();
    for (int step = 1; step <= 10; step++) {
      mono.advanceMillis(100);
      played.replayed((5000 + 400 * step) * MILLI);
    }
    assertEquals(4, age(begin), 1e-6, "at four times its speed");
    assertEquals(begin + 500 * MILLI, played.received(7000 * MILLI));
    mono.advanceMillis(30_000);
    assertEquals(4, age(begin), 1e-6, "it stands still");
    assertEquals(0, age(mono.nanos()), 1e-6);

    played.moved(1000 * MILLI);
    assertEquals(2, age(mono.nanos() - 2000 * MILLI), 1e-6, "what holds at the time it was moved to");
  }
}
