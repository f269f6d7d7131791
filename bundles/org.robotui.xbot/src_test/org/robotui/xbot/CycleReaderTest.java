package org.robotui.xbot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.xbot.internal.CycleMemory;

class CycleReaderTest {
  private static final int KEPT = 8;

  private final Ring ring = new Ring();
  private final CycleReader reader = new CycleReader(() -> ring);

  /** Memory that holds the last cycles. */
  private static final class Ring implements CycleMemory {
    private long newest;
    private long torn;

    @Override
    public long newestCycle() {
      return newest;
    }

    @Override
    public long oldestCycle(long now) {
      return Math.max(1, now - KEPT);
    }

    @Override
    public Optional<StateFrame> state(long cycle) {
      return cycle == torn || cycle > newest || cycle < oldestCycle(newest) ? Optional.empty()
          : Optional.of(new StateFrame(cycle, cycle, StateFrame.Hardware.OK, List.of(), List.of(), List.of()));
    }
  }

  private List<Long> all() {
    List<Long> cycles = new ArrayList<>();
    for (Optional<StateFrame> next = reader.next(); next.isPresent(); next = reader.next()) {
      cycles.add(next.get().cycle());
    }
    return cycles;
  }

  @Test
  void cyclesFollowFromTheNewestOneOn() {
    assertEquals(List.of(), all(), "before the first");
    ring.newest = 100;
    assertEquals(List.of(100L), all());
    ring.newest = 103;
    assertEquals(List.of(101L, 102L, 103L), all());
    assertEquals(0, reader.lost());
  }

  @Test
  void whatWasWrittenOverIsCounted() {
    ring.newest = 100;
    all();
    ring.newest = 120;
    assertEquals(112, all().getFirst());
    assertEquals(11, reader.lost());
  }

  @Test
  void aCycleThatIsBeingWrittenIsReadLater() {
    ring.newest = 100;
    all();
    ring.newest = 102;
    ring.torn = 101;
    assertTrue(reader.next().isEmpty());
    ring.torn = 0;
    assertEquals(List.of(101L, 102L), all());
    assertEquals(0, reader.lost());
  }

  @Test
  void aProcessThatCameAnewBeginsAtItsFirstCycle() {
    ring.newest = 100;
    all();
    ring.newest = 3;
    assertEquals(List.of(1L, 2L, 3L), all());
    assertEquals(0, reader.lost());
  }
}
