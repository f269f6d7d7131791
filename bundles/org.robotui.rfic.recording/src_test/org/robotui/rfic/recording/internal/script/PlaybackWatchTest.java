package org.robotui.rfic.recording.internal.script;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TimelineState;

class PlaybackWatchTest {
  private static final long SECOND = 1_000_000_000L;
  private static final long START = 1_700_000_000L * SECOND;

  private TimelineState state = at(0, false, 1, false);
  private long nanos;
  private final PlaybackWatch watch = new PlaybackWatch(() -> state, () -> nanos);

  private static TimelineState at(double seconds, boolean playing, double speed, boolean looping) {
    return new TimelineState(Optional.of(new TimeRange(START, START + 100 * SECOND)), time(seconds), playing, speed,
        looping, Optional.empty(), List.of(), false);
  }

  private static long time(double seconds) {
    return START + Math.round(seconds * 1e9);
  }

  private List<String> after(double seconds, TimelineState next) {
    nanos += Math.round(seconds * 1e9);
    state = next;
    return watch.next();
  }

  @Test
  void playingPausingSpeedAndLoopAreSaid() {
    assertEquals(List.of("play();"), after(0.2, at(0, true, 1, false)));
    assertEquals(List.of(), after(0.2, at(0.2, true, 1, false)));
    assertEquals(List.of("playbackSpeed(2.5);"), after(0.2, at(0.7, true, 2.5, false)));
    assertEquals(List.of("playbackLoop(true);"), after(0.2, at(1.2, true, 2.5, true)));
    assertEquals(List.of("pause();"), after(0.2, at(1.7, false, 2.5, true)));
  }

  @Test
  void ofADragTheLastPositionIsSaid() {
    assertEquals(List.of(), after(0.2, at(10, false, 1, false)));
    assertEquals(List.of(), after(0.2, at(20, false, 1, false)));
    assertEquals(List.of("seek(20);"), after(0.2, at(20, false, 1, false)));
    assertEquals(List.of(), after(0.2, at(20, false, 1, false)));
  }

  @Test
  void aJumpWhilePlayingIsSaidAndBeginningAgainIsNot() {
    after(0.2, at(50, true, 1, true));
    assertEquals(List.of(), after(0.2, at(70, true, 1, true)), "once it goes on");
    assertEquals(List.of("seek(70.2);"), after(0.2, at(70.2, true, 1, true)));
    assertEquals(List.of(), after(0.2, at(0.1, true, 1, true)), "at its end it begins again");
    assertEquals(List.of(), after(0.2, at(0.3, true, 1, true)));
  }

  @Test
  void bookmarksAndARangeAreSaid() {
    Optional<TimeRange> span = state.span();
    Bookmark mark = new Bookmark(time(5), "the \"stop\"");
    TimelineState marked = new TimelineState(span, time(0), false, 1, false,
        Optional.of(new TimeRange(time(2), time(8))), List.of(mark), false);
    assertEquals(List.of("playbackRange(2, 8);", "bookmark(\"the \\u0022stop\\u0022\", 5);"), after(0.2, marked));
    assertEquals(List.of("playbackRange();"), after(0.2, at(0, false, 1, false)));
  }

  @Test
  void anotherRecordingIsNothingThatTheTimelineWasMovedBy() {
    TimelineState other = new TimelineState(Optional.of(new TimeRange(0, SECOND)), 0, true, 1, false, Optional.empty(),
        List.of(), false);
    assertEquals(List.of(), after(0.2, other));
    assertEquals(List.of(), after(0.2, TimelineState.EMPTY));
  }
}
