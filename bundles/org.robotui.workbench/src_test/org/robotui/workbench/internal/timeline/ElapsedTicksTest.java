package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.replay.TimeRange;
import org.robotui.workbench.internal.timeline.ElapsedTicks.Tick;

class ElapsedTicksTest {
  private static final long BEGIN = 1_700_000_000_123_456_789L;
  private static final int WIDTH = 800;

  private static List<Tick> ticks(long from, long length) {
    return ElapsedTicks.of(new TimeScale(new TimeRange(BEGIN + from, BEGIN + from + length), 0, WIDTH), BEGIN, 80);
  }

  @ParameterizedTest
  @ValueSource(longs = {100, 5_000, 1_000_000, 37_000_000, 1_000_000_000L, 61_000_000_000L, 3_600_000_000_000L,
      90_000_000_000_000L, 8_000_000_000_000_000L})
  void atAnyZoomLabelsDifferAndAreFarEnoughApart(long length) {
    List<Tick> ticks = ticks(12_345_678, length);
    assertFalse(ticks.isEmpty());
    assertTrue(ticks.size() <= WIDTH / 80 + 1, () -> ticks.toString());
    assertEquals(ticks.size(), ticks.stream().map(Tick::label).collect(Collectors.toSet()).size());
    TimeScale scale = new TimeScale(new TimeRange(BEGIN + 12_345_678, BEGIN + 12_345_678 + length), 0, WIDTH);
    for (int i = 1; i < ticks.size(); i++) {
      assertTrue(scale.x(ticks.get(i).time()) - scale.x(ticks.get(i - 1).time()) >= 79);
    }
  }

  @Test
  void minutesAreMinutes() {
    assertEquals(List.of("0\u00a0s", "1:00", "2:00", "3:00", "4:00", "5:00", "6:00"),
        ticks(0, 400_000_000_000L).stream().map(Tick::label).toList());
  }

  @Test
  void stepsAreRound() {
    assertEquals(1, ElapsedTicks.step(0));
    assertEquals(5_000, ElapsedTicks.step(2_001));
    assertEquals(15_000_000_000L, ElapsedTicks.step(10_000_000_001L));
    assertEquals(172_800_000_000_000L, ElapsedTicks.step(86_400_000_000_001L));
  }

  @Test
  void theLongestTimeThatThereIsHasAnEnd() {
    TimeScale scale = new TimeScale(new TimeRange(0, Long.MAX_VALUE), 0, WIDTH);
    assertTrue(ElapsedTicks.of(scale, 0, 80).size() <= 11);
  }
}
