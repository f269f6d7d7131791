package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.api.replay.Lane;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Track;
import org.robotui.api.replay.TrackId;
import org.robotui.workbench.internal.timeline.LaneDensity.Counted;
import org.robotui.workbench.internal.timeline.LaneDensity.TrackLane;

class LaneDensityTest {
  private static TrackLane lane(long from, long to, Integer... counts) {
    Lane lane = new Lane("/odom", "Odometry", 0, List.of(counts));
    return new TrackLane(
        new Track(new TrackId("Keira", "base"), Path.of("a.bag"), new TimeRange(from, to), 0, List.of(lane), List.of()),
        lane);
  }

  private static double[] columns(TrackLane lane, long from, long to, int width) {
    return LaneDensity.columns(List.of(lane), new TimeScale(new TimeRange(from, to), 0, width));
  }

  @Test
  void aPartForEachColumnIsWhatItIs() {
    assertArrayEquals(new double[]{4, 0, 2, 6}, columns(lane(0, 400, 4, 0, 2, 6), 0, 400, 4), 1e-6);
  }

  @Test
  void manyPartsBecomeOneColumn() {
    assertArrayEquals(new double[]{4, 8}, columns(lane(0, 400, 4, 0, 2, 6), 0, 400, 2), 1e-6);
  }

  @Test
  void aPartOfManyColumnsIsSharedAmongThem() {
    assertArrayEquals(new double[]{2, 2, 0, 0}, columns(lane(0, 400, 4, 0), 0, 400, 4), 1e-6);
    assertArrayEquals(new double[]{1, 1, 1, 1}, columns(lane(0, 400, 4, 0), 0, 200, 4), 1e-6);
  }

  @Test
  void noMessageIsLostWhereverThePartsEnd() {
    double[] columns = columns(lane(13, 977, 3, 1, 4, 1, 5, 9, 2, 6), 0, 1000, 117);
    assertEquals(31, Arrays.stream(columns).sum(), 1e-6);
  }

  @Test
  void theGapBetweenMessagesStaysEmpty() {
    double[] columns = columns(lane(0, 300, 5, 0, 5), 0, 300, 300);
    assertEquals(0, Arrays.stream(columns, 101, 199).sum());
  }

  @Test
  void aRecordingOfOneMomentIsSeen() {
    assertEquals(3, Arrays.stream(columns(lane(500, 500, 3), 0, 1000, 10)).sum(), 1e-6);
  }

  @Test
  void countsAreThoseOfWholeParts() {
    TrackLane lane = lane(0, 400, 4, 0, 2, 6);
    assertEquals(new Counted(new TimeRange(0, 100), 4), LaneDensity.count(lane, new TimeRange(10, 20)));
    assertEquals(new Counted(new TimeRange(100, 400), 8), LaneDensity.count(lane, new TimeRange(150, 310)));
    assertEquals(0, LaneDensity.count(lane, new TimeRange(500, 600)).messages());
    assertEquals(0, LaneDensity.count(lane(0, 400), new TimeRange(0, 10)).messages());
  }
}
