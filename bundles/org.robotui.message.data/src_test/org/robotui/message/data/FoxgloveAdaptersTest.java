package org.robotui.message.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;
import org.robotui.message.DefinitionException;
import org.robotui.message.DynamicCodec;
import org.robotui.message.Generation;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;

class FoxgloveAdaptersTest {
  private static final FrameNames NAMES = new FrameNames("robby", ClockKind.ROBOT);
  private static final String LOG =
      "time timestamp\nuint8 level\nstring message\nstring name\nstring file\nuint32 line\n";

  private final Adapters adapters = new Adapters();

  @SuppressWarnings("unchecked") // all of these adapters read records
  private <D extends Data> D converted(String type, Class<D> data, DynamicRecord record) {
    Adapter<DynamicRecord, ?> adapter = (Adapter<DynamicRecord, ?>) adapters.ofFields(type);
    return data.cast(adapter.convert().apply(record, NAMES).orElseThrow());
  }

  private static NamedRecord turned(double yaw, double x) {
    Quaternion q = Quaternion.fromYaw(yaw);
    return NamedRecord.of("position", NamedRecord.of("x", x), "orientation",
        NamedRecord.of("x", 0, "y", 0, "z", q.z(), "w", q.w()));
  }

  @Test
  void aScanIsTurnedAsItsPoseSaysAndRefusedWhereThatWouldMoveIt() {
    LaserScan scan = converted("foxglove.LaserScan", LaserScan.class, NamedRecord.of("frame_id", "laser", "pose",
        turned(0.5, 0), "start_angle", -1, "end_angle", 1, "ranges", new double[]{1, 3, Double.POSITIVE_INFINITY}));
    assertEquals(new FrameId("robby", "laser"), scan.frame());
    assertEquals(-0.5, scan.angle(0), 1e-9);
    assertEquals(1.5, scan.angle(2), 1e-9);
    assertTrue(scan.isEcho(1) && !scan.isEcho(2));
    NamedRecord moved = NamedRecord.of("pose", turned(0, 2), "ranges", new double[]{1});
    assertThrows(IllegalArgumentException.class, () -> converted("foxglove.LaserScan", LaserScan.class, moved));
  }

  @Test
  void aCloudIsMovedAsItsPoseSays() {
    ByteBuffer points = ByteBuffer.allocate(16).order(ByteOrder.LITTLE_ENDIAN).putFloat(1).putFloat(0).putFloat(5);
    List<Object> fields = List.of(NamedRecord.of("name", "x", "offset", 0, "type", "FLOAT32"),
        NamedRecord.of("name", "y", "offset", 4, "type", 7), NamedRecord.of("name", "z", "offset", 8, "type", 7));
    PointCloud cloud =
        converted("foxglove.PointCloud", PointCloud.class, NamedRecord.of("pose", turned(Math.PI / 2, 10),
            "point_stride", 16, "fields", fields, "data", Bytes.wrap(points.rewind())));
    ByteBuffer moved = cloud.points().buffer(ByteOrder.LITTLE_ENDIAN);
    assertEquals(1, cloud.size());
    assertEquals(10, moved.getFloat(0), 1e-5);
    assertEquals(1, moved.getFloat(4), 1e-5);
    assertEquals(5, moved.getFloat(8), 1e-5);
  }

  @Test
  void aGridWithOccupancyIsAMapAndOneWithoutIsRefused() {
    NamedRecord red = NamedRecord.of("name", "red", "offset", 0, "type", "UINT8");
    NamedRecord occupancy = NamedRecord.of("name", "occupancy", "offset", 1, "type", "INT8");
    Bytes data = Bytes.of((byte) 9, (byte) 100, (byte) 9, (byte) -1, (byte) 7, (byte) 9, (byte) 0, (byte) 9, (byte) 50);
    NamedRecord good = NamedRecord.of("column_count", 2, "cell_size", NamedRecord.of("x", 0.5, "y", 0.5), "row_stride",
        4, "cell_stride", 2,
        "fields", List.of(red, occupancy), "data", data);
    GridMap map = converted("foxglove.Grid", GridMap.class, good);
    assertEquals(List.of(2, 2), List.of(map.width(), map.height()));
    assertEquals(Bytes.of((byte) 100, (byte) -1, (byte) 9, (byte) 9), map.cells());
    NamedRecord lying =
        NamedRecord.of("column_count", 2_000_000_000, "cell_size", NamedRecord.of("x", 0.5, "y", 0.5), "row_stride", 1,
            "cell_stride", 2, "fields", List.of(occupancy), "data", data);
    assertThrows(IllegalArgumentException.class, () -> converted("foxglove.Grid", GridMap.class, lying));
    NamedRecord colours = NamedRecord.of("cell_size", NamedRecord.of(), "fields", List.of(red, red));
    assertThrows(IllegalArgumentException.class, () -> converted("foxglove.Grid", GridMap.class, colours));
  }

  @Test
  void transformsAreThoseOfRos() {
    NamedRecord transform =
        NamedRecord.of("timestamp", NamedRecord.of("sec", 2, "nsec", 3), "parent_frame_id", "map", "child_frame_id",
            "base", "translation", NamedRecord.of("x", 1, "y", 2, "z", 3), "rotation", NamedRecord.of("w", 1));
    TransformSet one = converted("foxglove.FrameTransform", TransformSet.class, transform);
    assertEquals(one, converted("foxglove.FrameTransforms", TransformSet.class, NamedRecord.of("transforms",
        List.of(transform))));
    assertEquals(new Vector3(1, 2, 3), one.transforms().getFirst().parentFromChild().translation());
    assertEquals(2_000_000_003L, one.transforms().getFirst().stamp().nanos());
    assertTrue(FoxgloveTransforms.is("foxglove_msgs/FrameTransform") && !FoxgloveTransforms.is("foxglove.Log"));
  }

  @Test
  void theSameSchemaIsReadAsAMessageOfRos() throws DefinitionException, MessageException {
    MessageSchema schema = MessageSchema.parse("foxglove_msgs/Log", LOG, Generation.ROS1);
    DynamicRecord record = new MessageRecord(new DynamicCodec(schema).build(Map.of("timestamp", 7_000_000_001L,
        "level", 4, "message", "hot", "name", "motor", "file", "m.c", "line", 12)));
    assertSame(LogEntry.class, adapters.of("foxglove_msgs/Log").data());
    LogEntry entry = converted("foxglove_msgs/Log", LogEntry.class, record);
    assertEquals(new LogEntry(Severity.ERROR, "motor", "hot", "m.c:12"), entry);
  }

  @Test
  void whatIsNotKnownStaysARecord() {
    MapRecord record = new MapRecord("odd", Map.of("a", new FieldValue.Flag(true)));
    assertSame(record, converted("odd", DynamicRecord.class, record));
    assertEquals(DynamicRecord.class, adapters.ofFields("sensor_msgs/LaserScan").data());
  }
}
