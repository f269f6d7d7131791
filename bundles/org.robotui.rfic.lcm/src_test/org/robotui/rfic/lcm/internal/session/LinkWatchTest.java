package org.robotui.rfic.lcm.internal.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmStatistics;

/** When the link is green, and what it says when it is not. */
class LinkWatchTest {
  private static final long SECOND = 1_000_000_000L;

  private final LinkWatch watch = new LinkWatch("udpm://x", false, 0);

  private static LcmStatistics statistics(long lost, long incomplete, int granted) {
    return new LcmStatistics(100, 100, 0, 0, lost, incomplete, 0, 0, 0, 16 << 20, granted, "");
  }

  private LinkState state(LcmStatistics statistics, long now) {
    return watch.state(new LcmState.Connected("there"), statistics, "", now);
  }

  @Test
  void onlyMessagesMakeItGreen() {
    assertInstanceOf(LinkState.Connecting.class, state(statistics(0, 0, 16 << 20), SECOND));
    assertTrue(state(statistics(0, 0, 16 << 20), 6 * SECOND).reason().contains("nobody has sent anything yet"));
    watch.heard(7 * SECOND);
    assertEquals(new LinkState.Connected("udpm://x"), state(statistics(0, 0, 16 << 20), 8 * SECOND));
    assertEquals("no message for 6 s", state(statistics(0, 0, 16 << 20), 13 * SECOND).reason());
  }

  @Test
  void lossesAreToldForAWhileWithTheRemedy() {
    watch.heard(SECOND);
    assertInstanceOf(LinkState.Connected.class, state(statistics(5, 5, 200_000), SECOND));
    watch.heard(2 * SECOND);
    String reason = state(statistics(7, 6, 200_000), 2 * SECOND).reason();
    assertTrue(reason.contains("2 never came, 1 came in part"), reason);
    assertTrue(
        reason.contains(
            "a receive buffer of 195 kB where 16384 kB were asked for: run sysctl -w net.core.rmem_max=16777216"),
        reason);
    watch.heard(20 * SECOND);
    state(statistics(7, 6, 200_000), 12 * SECOND);
    assertInstanceOf(LinkState.Connected.class, state(statistics(7, 6, 200_000), 20 * SECOND));
  }
}
