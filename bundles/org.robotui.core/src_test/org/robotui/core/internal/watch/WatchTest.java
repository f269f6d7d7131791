package org.robotui.core.internal.watch;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.robotui.core.internal.support.Await;

/** On a clock of the test. */
class WatchTest {
  private static final long SECOND = 1_000_000_000L;

  private final AtomicLong now = new AtomicLong(5 * SECOND);
  private final AtomicInteger asked = new AtomicInteger();
  private final List<Long> looks = new CopyOnWriteArrayList<>();

  private long clock() {
    asked.incrementAndGet();
    return now.get();
  }

  /** Until it has certainly read the clock as it is now, and done what follows from that. */
  private void awaitRounds() {
    int before = asked.get();
    Await.until("it goes round", () -> asked.get() > before + 2);
  }

  @Test
  void afterTheProcessWasStoppedAllHaveTimeBeforeItLooksAgain() {
    try (Watch watch = new Watch(this::clock)) {
      watch.add(looks::add);
      Await.until("it looks", () -> !looks.isEmpty());
      long resumed = now.addAndGet(12 * SECOND);
      awaitRounds();
      now.addAndGet(SECOND);
      awaitRounds();
      now.addAndGet(SECOND / 2);
      awaitRounds();
      assertTrue(looks.stream().allMatch(at -> at < resumed), looks::toString);
      now.addAndGet(SECOND);
      Await.until("it looks again", () -> looks.getLast() > resumed);
    }
  }

  @Test
  void aMomentOfABusyMachineChangesNothing() {
    try (Watch watch = new Watch(this::clock)) {
      watch.add(looks::add);
      for (int i = 0; i < 5; i++) {
        long at = now.addAndGet(SECOND * 9 / 10);
        Await.until("it looks", () -> looks.contains(at));
      }
    }
  }
}
