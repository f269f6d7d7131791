package org.robotui.bridge.internal.change;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.FakeSettings;
import org.robotui.testkit.host.FakeClock;

class ValueRewritingTest {
  private static final long SECOND = 1_000_000_000L;
  private static final Stamp STAMP = new Stamp(10 * SECOND, ClockKind.ROBOT);
  private static final MapRecord MESSAGE = new MapRecord("demo/Pose", Map.of(
      "header", nested(Map.of("stamp", new FieldValue.Time(10 * SECOND), "frame_id", new FieldValue.Text("/map"))),
      "child_frame_id", new FieldValue.Text("base"),
      "parts", new FieldValue.Items(List.of(
          nested(Map.of("stamp", new FieldValue.Time(9 * SECOND), "frame_id", new FieldValue.Text("arm"))),
          nested(Map.of("stamp", new FieldValue.Time(0), "frame_id", new FieldValue.Text("")))))));

  private static FieldValue nested(Map<String, FieldValue> fields) {
    return new FieldValue.Nested(new MapRecord("", fields));
  }

  private static FakeClock clock(long now, Duration offset) {
    return new FakeClock(new Stamp(now, ClockKind.ROBOT), ClockKind.ROBOT, Optional.of(offset), 0);
  }

  private static StampMoving stamps(Map<String, Object> settings, boolean back) {
    FakeSettings values = new FakeSettings(BridgeWords.SCHEMA);
    settings.forEach(values::set);
    return StampMoving.of(values.current(), back, clock(20 * SECOND, Duration.ofSeconds(1)),
        clock(40 * SECOND, Duration.ofSeconds(6)));
  }

  private static FrameRenaming frames(Map<String, String> names, String prefix) {
    return new FrameRenaming("Keira", names, prefix, false);
  }

  private static Envelope<Data> envelope(Optional<Stamp> stamp) {
    return new Envelope<>(MESSAGE, new SourceId("base", "pose"), 0, stamp, System.nanoTime(), Optional.empty());
  }

  private static String at(DynamicRecord record, String path) {
    return switch (record.at(FieldPath.parse(path)).orElseThrow()) {
      case FieldValue.Text text -> text.value();
      case FieldValue.Time time -> Long.toString(time.nanos() / SECOND);
      default -> throw new AssertionError(path);
    };
  }

  @Test
  void framesWithinMessagesAreRenamedWhereverTheyStand() {
    DynamicRecord renamed = new ValueRewriting(frames(Map.of("map", "world"), "n/"), stamps(Map.of(), false))
        .of(MESSAGE, Optional.of(STAMP));
    assertEquals("world", at(renamed, "header.frame_id"));
    assertEquals("n/base", at(renamed, "child_frame_id"));
    assertEquals("n/arm", at(renamed, "parts[0].frame_id"));
    assertEquals("", at(renamed, "parts[1].frame_id"), "no frame is no frame on the other side either");
    assertEquals("10", at(renamed, "header.stamp"));
  }

  @Test
  void namesComeBackOnTheWayBack() {
    FrameRenaming back = frames(Map.of("map", "world"), "n/").back("Natalie");
    assertEquals(new FrameId("Natalie", "map"), back.of(new FrameId("Keira", "world")));
    assertEquals(new FrameId("Natalie", "base"), back.of(new FrameId("Keira", "n/base")));
    assertEquals(new FrameId("Natalie", "odom"), back.of(new FrameId("Keira", "odom")));
  }

  @Test
  void dataTypesHaveTheirFramesAndStampsInside() {
    TransformSet set = new TransformSet(List.of(new FrameTransform(new FrameId("Natalie", "map"),
        new FrameId("Natalie", "base"), STAMP, RigidTransform.IDENTITY, false)));
    TransformSet moved = (TransformSet) new ValueRewriting(frames(Map.of(), "n/"),
        stamps(Map.of("stamps", "move", "stamp_offset", 0.5), false)).of(set, Optional.of(STAMP));
    FrameTransform transform = moved.transforms().getFirst();
    assertEquals(new FrameId("Keira", "n/base"), transform.child());
    assertEquals(15 * SECOND + SECOND / 2, transform.stamp().nanos());
  }

  @Test
  void stampsAreMovedByTheDifferenceOfTheClocks() {
    StampMoving moving = stamps(Map.of("stamps", "move"), false);
    assertEquals(15 * SECOND, moving.of(envelope(Optional.of(STAMP))).orElseThrow().nanos());
    DynamicRecord moved = new ValueRewriting(frames(Map.of(), ""), moving).of(MESSAGE, moving.of(envelope(Optional.of(
        STAMP))));
    assertEquals("15", at(moved, "header.stamp"));
    assertEquals("14", at(moved, "parts[0].stamp"));
    assertEquals("0", at(moved, "parts[1].stamp"), "no stamp is no stamp on the other side either");
  }

  @Test
  void aGivenOffsetIsTakenAwayOnTheWayBack() {
    assertEquals(12 * SECOND,
        stamps(Map.of("stamp_offset", 2.0), false).of(envelope(Optional.of(STAMP))).orElseThrow().nanos());
    assertEquals(8 * SECOND,
        stamps(Map.of("stamp_offset", 2.0), true).of(envelope(Optional.of(STAMP))).orElseThrow().nanos());
  }

  @Test
  void newStampsAreTheTimeOfReceptionByTheOtherClock() {
    long made = stamps(Map.of("stamps", "now"), false).of(envelope(Optional.of(STAMP))).orElseThrow().nanos();
    assertTrue(made <= 40 * SECOND && made > 0, () -> "it is " + made);
  }

  @Test
  void whatHasNothingToChangeStaysTheSameMessage() {
    ValueRewriting none = new ValueRewriting(frames(Map.of(), ""), stamps(Map.of(), false));
    assertSame(MESSAGE, none.of(MESSAGE, Optional.of(STAMP)));
  }
}
