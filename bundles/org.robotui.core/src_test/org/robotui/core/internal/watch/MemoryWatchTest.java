package org.robotui.core.internal.watch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.lang.management.MemoryUsage;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.robotui.core.internal.fence.HeapBound;

class MemoryWatchTest {
  private static final long MAX = 100 << 20;

  private static final String REMEDY =
      "close views or robots, or start it with more, as by " + HeapBound.remedy(Runtime.getRuntime().maxMemory());

  private final List<String> happened = new ArrayList<>();
  private long used;
  private final MemoryWatch watch = new MemoryWatch(
      () -> List.of(new MemoryUsage(0, used, MAX, MAX)), () -> happened.add("stop"), happened::add);

  private void use(long bytes) {
    used = bytes;
    watch.check(0);
  }

  @Test
  void aFullHeapStopsAllRobotsOnceAndSaysSo() {
    use(MAX * 96 / 100);
    use(MAX);
    assertEquals(List.of("stop", "the memory is used up (96 of 100 MB): all robots are stopped; " + REMEDY), happened);
  }

  @Test
  void aHeapThatIsNearlyFullIsToldOnceAndStopsNobody() {
    use(MAX * 79 / 100);
    assertEquals(List.of(), happened);
    use(MAX * 81 / 100);
    use(MAX * 75 / 100);
    use(MAX * 94 / 100);
    assertEquals(List.of("RobotUI holds 81 of 100 MB of memory, and stops all robots when they are used up: " + REMEDY),
        happened);
  }

  @Test
  void aHeapThatFillsAgainIsToldAgain() {
    use(MAX * 81 / 100);
    use(MAX * 69 / 100);
    use(MAX * 81 / 100);
    assertEquals(2, happened.size(), happened.toString());
  }

  @Test
  void afterAStopNothingLessIsSaidUntilThereIsRoom() {
    use(MAX);
    use(MAX * 81 / 100);
    assertEquals(2, happened.size(), happened.toString());
  }

  @Test
  void itIsToldAgainAfterThereWasRoom() {
    use(MAX);
    use(MAX / 2);
    use(MAX);
    assertEquals(4, happened.size());
  }

  @Test
  void itSaysSoLaterWhereItCouldNotAtOnce() {
    AtomicInteger failures = new AtomicInteger(2);
    MemoryWatch starved =
        new MemoryWatch(() -> List.of(new MemoryUsage(0, MAX, MAX, MAX)), () -> happened.add("stop"), m -> {
          if (failures.getAndDecrement() > 0) {
            throw new OutOfMemoryError();
          }
          happened.add(m);
        });
    assertThrows(OutOfMemoryError.class, () -> starved.check(0));
    assertThrows(OutOfMemoryError.class, () -> starved.check(0));
    starved.check(0);
    starved.check(0);
    assertEquals(2, happened.size(), happened.toString());
  }

  @Test
  void thisMachineTellsHowFullItIs() {
    assertFalse(MemoryWatch.heap().get().isEmpty());
  }
}
