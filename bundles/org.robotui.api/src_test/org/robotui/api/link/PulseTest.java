package org.robotui.api.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class PulseTest {
  private static final long MILLI = 1_000_000;

  private final Pulse pulse = new Pulse();
  private long now = 1000 * MILLI;

  private void hear(int count, long everyMillis) {
    for (int i = 0; i < count; i++) {
      now += everyMillis * MILLI;
      pulse.heard(now);
    }
  }

  private long silentAfter(long millis) {
    return pulse.silentFor(now + millis * MILLI) / MILLI;
  }

  @Test
  void aRobotThatIsHeardOftenIsMissedAfterHalfASecond() {
    assertEquals(0, silentAfter(5000), "nothing was ever heard");
    hear(100, 20);
    assertEquals(0, silentAfter(400));
    assertEquals(600, silentAfter(600));
  }

  @Test
  void whatComesRarelyMayBeSilent() {
    hear(100, 300);
    assertEquals(0, silentAfter(2000));
  }

  @Test
  void aMasterThatAnswersSaysThatTheNetworkIsNotTheReason() {
    hear(100, 20);
    now += 700 * MILLI;
    pulse.answered(now);
    assertEquals(0, silentAfter(0));
    assertEquals(0, silentAfter(3000), "a driver has ended; the robot can be driven all the same");
    hear(100, 20);
    assertTrue(silentAfter(600) > 0, "and it is missed again once it was heard again");
  }

  @Test
  void aMasterThatAnswersWhileAllIsWellChangesNothing() {
    hear(100, 20);
    pulse.answered(now + 10 * MILLI);
    assertTrue(silentAfter(600) > 0);
  }

  @Test
  void anOutageDoesNotMakeTheRobotSeemRare() {
    hear(200, 20);
    now += 2000 * MILLI;
    hear(3, 20);
    assertTrue(silentAfter(600) > 0);
  }
}
