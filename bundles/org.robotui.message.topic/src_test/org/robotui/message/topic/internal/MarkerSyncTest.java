package org.robotui.message.topic.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.ClockKind;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarkerSet.Entry;
import org.robotui.message.data.FrameNames;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerPose;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerUpdate;

class MarkerSyncTest {
  private static final FrameNames NAMES = new FrameNames("robby", ClockKind.ROBOT);
  private final List<String> complaints = new ArrayList<>();
  private final MarkerSync sync = new MarkerSync("/goals/feedback", complaints::add);

  private static InteractiveMarkerInit all(long number, String... names) {
    return new InteractiveMarkerInit("s", number,
        Arrays.stream(names).map(n -> SampleHandles.interactive(n, number)).toList());
  }

  private static InteractiveMarkerUpdate alive(long number) {
    return new InteractiveMarkerUpdate("s", number, InteractiveMarkerUpdate.KEEP_ALIVE, List.of(), List.of(),
        List.of());
  }

  private static InteractiveMarkerUpdate moved(long number, String name, double x) {
    InteractiveMarkerPose pose = new InteractiveMarkerPose(new Header(0, 0, "map"), SampleHandles.pose(x, 0, 0), name);
    return new InteractiveMarkerUpdate("s", number, InteractiveMarkerUpdate.UPDATE, List.of(), List.of(pose),
        List.of());
  }

  private static InteractiveMarkerUpdate erased(long number, String name) {
    return new InteractiveMarkerUpdate("s", number, InteractiveMarkerUpdate.UPDATE, List.of(), List.of(),
        List.of(name));
  }

  private static List<String> said(List<Entry> entries) {
    return entries.stream()
        .map(e -> e.name() + e.marker().map(m -> " at " + m.pose().translation().x()).orElse(" gone")).toList();
  }

  @Test
  void allMarkersCountWhenASignOfLifeShowsThatNothingIsMissing() {
    assertEquals(List.of(), sync.take(all(7, "a", "b"), NAMES));
    assertFalse(sync.synchronised());
    assertEquals(List.of("a at 7.0", "b at 7.0"), said(sync.take(alive(7), NAMES)));
    assertTrue(sync.synchronised());
    assertEquals(List.of(), sync.take(alive(7), NAMES));
  }

  @Test
  void updatesThatCameBeforeTheListAreTakenAfterIt() {
    sync.take(moved(6, "a", 60), NAMES);
    sync.take(moved(7, "a", 70), NAMES);
    sync.take(moved(8, "a", 80), NAMES);
    assertEquals(List.of("a at 80.0"), said(sync.take(all(6, "a"), NAMES)));
    assertEquals(List.of("a gone"), said(sync.take(erased(9, "a"), NAMES)));
  }

  @Test
  void aMovedMarkerKeepsItsControls() {
    sync.take(all(1, "a"), NAMES);
    InteractiveMarker before = sync.take(alive(1), NAMES).getFirst().marker().orElseThrow();
    InteractiveMarker after = sync.take(moved(2, "a", 5), NAMES).getFirst().marker().orElseThrow();
    assertSame(before.controls(), after.controls());
    assertEquals(5, after.pose().translation().x());
    assertEquals(List.of(), sync.take(moved(3, "who", 5), NAMES), "of a marker that is not known");
  }

  @Test
  void aGapIsMendedWithTheNextListAndSaid() {
    sync.take(all(1, "a", "b"), NAMES);
    sync.take(alive(1), NAMES);
    assertEquals(List.of(), sync.take(moved(3, "a", 30), NAMES));
    assertFalse(sync.synchronised());
    assertEquals(1, complaints.size(), complaints.toString());
    assertEquals(List.of("a at 3.0", "b gone"), said(sync.take(all(3, "a"), NAMES)));
    assertEquals(List.of("a at 40.0"), said(sync.take(moved(4, "a", 40), NAMES)));
  }

  @Test
  void aServerThatBeganAnewIsFollowed() {
    sync.take(all(50, "a"), NAMES);
    sync.take(alive(50), NAMES);
    sync.take(all(1, "c"), NAMES);
    assertEquals(List.of("a gone", "c at 1.0"), said(sync.take(alive(1), NAMES)));
  }

  @Test
  void whatWaitsIsBounded() {
    for (int number = 0; number < 10_000; number++) {
      sync.take(moved(number, "a", number), NAMES);
    }
    assertEquals(List.of("a at 9999.0"), said(sync.take(all(9_950, "a"), NAMES)));
    assertFalse(new MarkerSync("", complaints::add).synchronised());
  }

  @Test
  void whatAServerAnswersCountsAtOnceAndIsAskedForAgainWhereAnUpdateIsMissing() {
    sync.take(moved(6, "a", 60), NAMES);
    sync.take(moved(8, "a", 80), NAMES);
    assertEquals(List.of("a at 80.0", "b at 7.0"), said(sync.answered(all(7, "a", "b"), NAMES)));
    assertTrue(sync.synchronised());
    assertEquals(List.of(), sync.take(moved(10, "a", 100), NAMES));
    assertFalse(sync.synchronised());
    assertEquals(List.of("a at 10.0", "b gone"), said(sync.answered(all(10, "a"), NAMES)).stream().sorted().toList());
  }
}
