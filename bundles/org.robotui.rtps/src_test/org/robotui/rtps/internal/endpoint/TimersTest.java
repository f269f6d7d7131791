package org.robotui.rtps.internal.endpoint;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class TimersTest {

  private final AtomicLong clock = new AtomicLong(100);
  private final Timers timers = new Timers(clock::get);
  private final List<Long> called = new ArrayList<>();
  private final Deque<Long> next = new ArrayDeque<>();

  private final Timers.Timer timer = timers.timer(now -> {
    called.add(now);
    return next.isEmpty() ? Timers.NEVER : next.poll();
  });

  private long at(long time) {
    clock.set(time);
    return timers.runDue();
  }

  @Test
  void theSoonestWakingCounts() {
    timer.wake(300);
    timer.wake(200);
    timer.wake(250);
    timer.wake(200);
    assertEquals(200, at(199));
    assertEquals(List.of(), called);
    assertEquals(Timers.NEVER, at(210));
    assertEquals(Timers.NEVER, at(400));
    assertEquals(List.of(210L), called);
  }

  @Test
  void whatATaskAsksForAndWhatOthersAskForMeanwhileAreBothKept() {
    List<Timers.Timer> other = new ArrayList<>();
    other.add(timers.timer(now -> {
      called.add(-now);
      other.getFirst().wake(150);
      return 500;
    }));
    other.getFirst().wake(120);
    assertEquals(150, at(120), "it was woken while it ran");
    next.add(600L);
    timer.wake(130);
    assertEquals(150, at(130));
    timer.wake(700);
    other.getFirst().cancel();
    assertEquals(600, at(599), "a later time postpones nothing, and nobody calls what is cancelled");
    other.getFirst().wake(10);
    assertEquals(Timers.NEVER, at(600));
    assertEquals(List.of(-120L, 130L, 600L), called);
  }
}
