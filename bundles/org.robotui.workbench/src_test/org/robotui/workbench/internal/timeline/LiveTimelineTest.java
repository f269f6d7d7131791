package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.replay.Timeline.LaneId;
import org.robotui.api.replay.TimelineState;

class LiveTimelineTest {
  private final Deque<Runnable> display = new ArrayDeque<>();
  private final LiveTimeline live = new LiveTimeline(display::add);
  private final PretendTimeline timeline = new PretendTimeline().filled();
  private int told;

  private void work() {
    while (!display.isEmpty()) {
      display.remove().run();
    }
  }

  @Test
  void manyChangesAreTakenUpOnce() {
    live.onChange(() -> told++);
    live.follow(Optional.of(timeline));
    work();
    assertEquals(1, told);
    for (int i = 0; i < 100; i++) {
      timeline.seek(PretendTimeline.BEGIN + i);
    }
    assertEquals(1, display.size());
    work();
    assertEquals(2, told);
    assertEquals(PretendTimeline.BEGIN + 99, live.state().position());
  }

  @Test
  void itIsThereOnlyWhileRecordingsAreOpen() {
    assertFalse(live.timeline().isPresent());
    live.follow(Optional.of(timeline));
    work();
    assertTrue(live.timeline().isPresent());
    timeline.empty();
    work();
    assertFalse(live.timeline().isPresent());
  }

  @Test
  void itIsSteppedByTheTopicThatIsChosenUntilThatIsChosenAgainOrHasGone() {
    LaneId odom = new LaneId(PretendTimeline.KEIRA, "/odom");
    live.follow(Optional.of(timeline));
    work();
    live.stepBy(odom);
    live.step(true);
    live.stepBy(odom);
    live.step(false);
    assertEquals(List.of("step on /odom", "step back"), timeline.asked);
    live.stepBy(odom);
    timeline.empty();
    work();
    assertEquals(Optional.empty(), live.stepped());
  }

  @Test
  void aServiceThatHasGoneIsForgotten() {
    live.follow(Optional.of(timeline));
    live.follow(Optional.empty());
    work();
    timeline.play();
    assertTrue(display.isEmpty());
    assertEquals(TimelineState.EMPTY, live.state());
  }
}
