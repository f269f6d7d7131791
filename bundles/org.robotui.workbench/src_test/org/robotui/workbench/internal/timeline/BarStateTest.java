package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.time.PointedTime;
import org.robotui.workbench.internal.timeline.LaneRows.Row;

class BarStateTest {
  private static final long BEGIN = PretendTimeline.BEGIN;
  private static final long SECOND = PretendTimeline.SECOND;

  private final PretendTimeline timeline = new PretendTimeline().filled();
  private final BarState bar = new BarState(new PointedTime());

  @BeforeEach
  void take() {
    bar.take(timeline.state(), timeline.tracks());
  }

  @Test
  void aFoldedRobotShowsItsRecordingOnly() {
    assertEquals(12, bar.rows().rows().size());
    bar.fold("Keira");
    assertEquals(4, bar.rows().rows().size());
    assertTrue(bar.rows().rows().getLast() instanceof Row.Head head && head.folded());
    bar.fold("Keira");
    assertEquals(12, bar.rows().rows().size());
    assertEquals("/odom", ((Row.Topic) bar.rows().at(LaneRows.HEIGHT).orElseThrow()).of().lane().topic());
    assertEquals(Optional.empty(), bar.rows().at(bar.rows().height()));
  }

  @Test
  void whilePlayingThePositionIsSeen() {
    bar.zoom(new TimeRange(BEGIN, BEGIN + 10 * SECOND));
    timeline.seek(BEGIN + 100 * SECOND);
    bar.take(timeline.state(), timeline.tracks());
    assertEquals(BEGIN, bar.scale(1000).shown().start());
    timeline.play();
    bar.take(timeline.state(), timeline.tracks());
    assertEquals(BEGIN + 99 * SECOND, bar.scale(1000).shown().start());
  }

  @Test
  void allOfTheTimeIsNoZoom() {
    bar.zoom(bar.all());
    assertFalse(bar.isZoomed());
    bar.zoom(new TimeRange(BEGIN, BEGIN + 1));
    assertTrue(bar.isZoomed());
    bar.take(
        new TimelineState(Optional.of(new TimeRange(0, 5)), 0, false, 1, false, Optional.empty(), List.of(), false),
        List.of());
    assertFalse(bar.isZoomed());
  }

  @Test
  void theTimeLeavesRoomForNamesOnlyWhereTheyAreShown() {
    int plain = bar.scale(800).left();
    bar.expand(true);
    assertTrue(bar.scale(800).left() > plain + 200);
    assertTrue(bar.scale(300).left() < 150);
  }

  @Test
  void problemsNameTheirFileWhereThereAreSeveral() {
    assertEquals(List.of("husky.mcap: the last chunk is cut off at byte 1048576"), bar.problems());
  }
}
