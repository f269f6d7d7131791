package org.robotui.message.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.RecordCodec;
import org.robotui.message.roboframe.BatteryStreamable;
import org.robotui.message.roboframe.GridStreamable;
import org.robotui.message.roboframe.LogLineStreamable;
import org.robotui.message.roboframe.ModuleStateStreamable;
import org.robotui.message.roboframe.ModuleStatesStreamable;
import org.robotui.message.roboframe.OdometryStreamable;
import org.robotui.message.roboframe.PictureStreamable;
import org.robotui.message.roboframe.PoseStreamable;
import org.robotui.message.roboframe.ScanStreamable;
import org.robotui.message.roboframe.TargetStreamable;
import org.robotui.message.roboframe.VelocityStreamable;

/** Common types of RoboFrame become data, and data become them. */
class RoboframeAdaptersTest {
  private static final long STAMP = 1_700_000_000_123_456_789L;
  private static final FrameNames NAMES = new FrameNames("robby", ClockKind.ROBOT);

  static Stream<Record> messages() {
    // No array: for one of records the compiler of the build names a wrong class here.
    return Stream.<Record>builder()
        .add(new ScanStreamable(STAMP, "laser", -1, 0.5f, 0.25f, 8, new float[]{1, Float.POSITIVE_INFINITY}))
        .add(new OdometryStreamable(STAMP, "odom", "base", 1, 2, 0.5, 0.25, 0.125, -0.5))
        .add(new PoseStreamable(STAMP, "map", 1, 2, -0.5)).add(new BatteryStreamable(STAMP, 12, -1, 0.75, true))
        .add(new PictureStreamable(STAMP, "camera", "jpeg", ByteBuffer.wrap(new byte[]{1, 2, 3})))
        .add(new GridStreamable(STAMP, "map", 0.05, 2, 1, -1, -2, ByteBuffer.wrap(new byte[]{0, 100}))).build();
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // the form of the adapter of a type is its record
  private static Data data(Record message) {
    Adapter adapter = new Adapters().of(RecordCodec.typeOf(message.getClass()));
    assertEquals(STAMP, adapter.stamp().applyAsLong(message));
    return (Data) ((java.util.Optional) adapter.convert().apply(message, NAMES)).orElseThrow();
  }

  /** What is made of the data again is the same message. */
  @ParameterizedTest
  @MethodSource("messages")
  void both_ways_agree(Record message) {
    String type = RecordCodec.typeOf(message.getClass());
    MessageRecord again =
        assertInstanceOf(MessageRecord.class, new DataMessages().message(data(message), type, STAMP).orElseThrow());
    assertEquals(whole(message), again.message());
  }

  @SuppressWarnings("unchecked") // the codec of its class
  private static <R extends Record> Object whole(R message) {
    return RecordCodec.of((Class<R>) message.getClass()).message(message);
  }

  @Test
  void modules_are_parts_of_diagnostics() {
    Diagnostics made = (Diagnostics) data(new ModuleStatesStreamable(STAMP,
        List.of(new ModuleStateStreamable("drive", false, "running", 7),
            new ModuleStateStreamable("vision", true, "stopped by an error", 3))));
    assertEquals(List.of(Diagnostics.Level.OK, Diagnostics.Level.ERROR),
        made.items().stream().map(Diagnostics.Item::level).toList());
    assertEquals("7", made.items().getFirst().values().get("runs"));
    assertEquals(new LogEntry(Severity.WARNING, "vision", "no ball", ""),
        data(new LogLineStreamable(STAMP, 2, "vision", "no ball")));
  }

  @Test
  void what_is_none_is_refused() {
    assertThrows(IllegalArgumentException.class, () -> data(new BatteryStreamable(STAMP, 12, 0, 3, false)));
    assertThrows(IllegalArgumentException.class, () -> data(new PoseStreamable(STAMP, "map", Double.NaN, 0, 0)));
  }

  @Test
  void commands_are_on_a_plane() {
    VelocityCommand motion = new VelocityCommand(new Vector3(1, 2, 9), new Vector3(9, 9, 3));
    assertEquals(new VelocityStreamable(1, 2, 3), command("roboframe/Velocity", motion));
    NavigationGoal goal = new NavigationGoal(NAMES.frame("map"),
        new RigidTransform(new Vector3(1, 2, 0), Quaternion.fromYaw(Math.PI / 2)));
    TargetStreamable target = (TargetStreamable) command("roboframe/Target", goal);
    assertEquals("map", target.frame());
    assertEquals(Math.PI / 2, target.heading(), 1e-12);
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // the data type of a command is that of its type
  private static Record command(String type, Data value) {
    CommandType found = CommandType.of(type).orElseThrow();
    return (Record) found.message().of(value, STAMP);
  }
}
