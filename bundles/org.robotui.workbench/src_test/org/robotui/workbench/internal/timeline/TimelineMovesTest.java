package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.TimeRange;

class TimelineMovesTest {
  private static final long BEGIN = PretendTimeline.BEGIN;
  private static final long SECOND = PretendTimeline.SECOND;

  private final PretendTimeline timeline = new PretendTimeline().filled();
  private final TimelineMoves moves = new TimelineMoves(timeline);

  @Test
  void itPlaysAndPausesInTurns() {
    moves.toggle();
    moves.toggle();
    assertEquals(List.of("play", "pause"), timeline.asked);
  }

  @Test
  void jumpsEndWhereTheTimeEnds() {
    moves.jump(10);
    moves.jump(-11);
    moves.jump(1e6);
    assertEquals(List.of("seek " + 10 * SECOND, "seek 0", "seek " + 300 * SECOND), timeline.asked);
  }

  @Test
  void theEndsAreThoseOfWhatIsPlayed() {
    timeline.range(Optional.of(new TimeRange(BEGIN + 5 * SECOND, BEGIN + 7 * SECOND)));
    moves.end(false);
    moves.end(true);
    assertEquals(List.of("range", "seek " + 5 * SECOND, "seek " + 7 * SECOND), timeline.asked);
  }

  @Test
  void bookmarksAreFoundFromThePosition() {
    timeline.mark(new Bookmark(BEGIN + 20 * SECOND, "b"));
    timeline.mark(new Bookmark(BEGIN + 10 * SECOND, "a"));
    timeline.asked.clear();
    moves.bookmark(false);
    moves.bookmark(true);
    moves.bookmark(true);
    moves.bookmark(true);
    moves.bookmark(false);
    assertEquals(List.of("seek " + 10 * SECOND, "seek " + 20 * SECOND, "seek " + 10 * SECOND), timeline.asked);
  }

  @Test
  void speedsGoInSteps() {
    moves.faster(true);
    moves.faster(false);
    moves.faster(false);
    assertEquals(List.of("speed 2.0", "speed 1.0", "speed 0.5"), timeline.asked);
    timeline.speed(100);
    moves.faster(true);
    assertEquals(100, timeline.state().speed());
  }

  @Test
  void oneEndOfWhatIsPlayedIsMovedAndPushesTheOther() {
    moves.limit(true, BEGIN + 10 * SECOND);
    assertEquals(Optional.of(new TimeRange(BEGIN + 10 * SECOND, BEGIN + 300 * SECOND)), timeline.state().range());
    moves.limit(false, BEGIN + 20 * SECOND);
    moves.limit(true, BEGIN + 30 * SECOND);
    assertEquals(Optional.of(new TimeRange(BEGIN + 30 * SECOND, BEGIN + 30 * SECOND)), timeline.state().range());
    moves.limit(true, BEGIN - SECOND);
    moves.limit(false, BEGIN + 999 * SECOND);
    assertEquals(Optional.empty(), timeline.state().range());
  }

  @Test
  void aRecordingIsShiftedToWhereTheEarliestBegins() {
    moves.align(timeline.tracks().getFirst());
    assertEquals(List.of("shift Husky " + -60 * SECOND), timeline.asked);
  }

  @Test
  void onlyTheNewestPlaceOfThePointerIsSought() {
    Deque<Runnable> display = new ArrayDeque<>();
    List<Long> sought = new ArrayList<>();
    NewestSeek seek = new NewestSeek(display::add, sought::add);
    for (long time = 1; time <= 50; time++) {
      seek.to(time);
    }
    display.remove().run();
    seek.to(60);
    display.remove().run();
    assertEquals(List.of(50L, 60L), sought);
    assertEquals(0, display.size());
  }
}
