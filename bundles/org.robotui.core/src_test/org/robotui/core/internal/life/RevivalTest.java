package org.robotui.core.internal.life;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class RevivalTest {
  private final Revival revival = new Revival();
  private long now = -5;

  private Optional<Duration> lateAfter(Duration time) {
    now += time.toNanos();
    return revival.next(now);
  }

  @Test
  void pausesGrowAndThereIsAnEnd() {
    for (Duration pause : Revival.PAUSES) {
      assertEquals(Optional.of(pause), lateAfter(Duration.ofSeconds(60)));
    }
    assertEquals(Optional.empty(), lateAfter(Duration.ofSeconds(60)));
    assertEquals(Optional.empty(), lateAfter(Duration.ofSeconds(60)));
  }

  @Test
  void whoWasWellForLongBeginsAnew() {
    lateAfter(Duration.ofSeconds(1));
    lateAfter(Duration.ofSeconds(10));
    assertEquals(Optional.of(Duration.ofSeconds(2)), lateAfter(Revival.WELL.plusSeconds(5)));
  }

  @Test
  void whoIsStartedByHandBeginsAnew() {
    Revival.PAUSES.forEach(pause -> lateAfter(pause));
    revival.begin();
    assertEquals(Optional.of(Duration.ofSeconds(2)), lateAfter(Duration.ofSeconds(1)));
  }
}
