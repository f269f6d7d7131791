package org.robotui.message.payload;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.RecordShape;
import org.robotui.message.Encoding;
import org.robotui.message.Generation;
import org.robotui.message.data.MessageForm;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.sensor_msgs.LaserScan;

/** Each format reads what it writes, and what servers write. */
class RosPayloadsTest {
  private static final RosDefinitions DEFINITIONS = new RosDefinitions(Map.of());
  private static final MessageForm<LaserScan> SCANS = new MessageForm.Bound<>(LaserScan.class, false);

  private static ByteBuffer bytes(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
  }

  private static Optional<FieldValue> at(DynamicRecord record, String path) {
    return record.at(FieldPath.parse(path));
  }

  @Test
  void messagesOfRosAreReadInBothEncodings() {
    for (Encoding encoding : List.of(Encoding.CDR, Encoding.ROS1)) {
      String type = encoding == Encoding.CDR ? "sensor_msgs/msg/LaserScan" : "sensor_msgs/LaserScan";
      RosFormat format = new RosFormat(DEFINITIONS.find(type).orElseThrow(), encoding);
      ByteBuffer payload = format.write(Map.of("header", Map.of("frame_id", "laser"), "ranges", List.of(1, 2.5)));
      assertArrayEquals(new float[]{1, 2.5f}, format.reading(SCANS).read(payload.duplicate()).ranges());
      assertEquals(Optional.of(new FieldValue.Text("laser")),
          at(format.read(payload.duplicate()), "header.frame_id"));
      assertEquals("sensor_msgs/LaserScan", format.type());
      assertTrue(format.shape().orElseThrow().field("ranges").isPresent());
      assertThrows(IllegalArgumentException.class, () -> format.write(Map.of("ranges", "many")));
    }
  }

  @Test
  void jsonOfATypeOfRosIsReadByItsDefinitionAndNullIsNoNumber() {
    JsonFormat format = JsonFormat.of("sensor_msgs/msg/LaserScan", DEFINITIONS, "");
    assertEquals("sensor_msgs/LaserScan", format.type());
    ByteBuffer payload = bytes("{\"header\": {\"stamp\": {\"sec\": 3, \"nanosec\": 4}}, \"ranges\": [1, null, 2.5]}");
    LaserScan scan = format.reading(SCANS).read(payload);
    assertArrayEquals(new float[]{1, Float.NaN, 2.5f}, scan.ranges());
    assertEquals(3_000_000_004L, scan.header().stamp());
  }

  @Test
  void jsonOfAnyOtherTypeIsARecordOfItsMembers() {
    JsonFormat format = JsonFormat.of("Battery", DEFINITIONS, "");
    DynamicRecord record = format.read(bytes("{\"a\": {\"b\": true}, \"n\": 3, \"big\": 12345678901234567890, "
        + "\"none\": null, \"list\": [1, \"x\"]}"));
    assertEquals(Optional.of(new FieldValue.Flag(true)), at(record, "a.b"));
    assertEquals(Optional.of(new FieldValue.Num(3, "3")), at(record, "n"));
    assertEquals(Optional.of(new FieldValue.Num(12345678901234567890.0, "12345678901234567890")), at(record, "big"));
    assertEquals(Optional.empty(), record.field("none"));
    assertEquals(new FieldValue.Items(List.of(new FieldValue.Num(1, "1"), new FieldValue.Text("x"))),
        record.field("list").orElseThrow());
    assertEquals(List.of("value"), format.read(bytes("\"alone\"")).fields());
    assertThrows(IllegalArgumentException.class, () -> format.reading(SCANS));
  }

  @Test
  void formsOfRecordsComeFromJsonSchema() {
    JsonFormat format = JsonFormat.of("Battery", DEFINITIONS, "{\"properties\": {\"level\": {\"type\": \"number\"}, "
        + "\"cells\": {\"type\": \"array\", \"items\": {\"type\": \"integer\"}}, \"odd\": 3}}");
    RecordShape shape = format.shape().orElseThrow();
    assertEquals(new FieldShape.Real(64), shape.field("level").orElseThrow().shape());
    assertEquals(new FieldShape.Many(new FieldShape.Whole(64, true), 0), shape.field("cells").orElseThrow().shape());
    assertEquals(new FieldShape.Text(), shape.field("odd").orElseThrow().shape());
    String deep = "{\"properties\": {\"a\": ".repeat(30) + "{}" + "}}".repeat(30);
    assertTrue(JsonFormat.of("Deep", DEFINITIONS, deep).shape().isPresent());
    assertTrue(JsonFormat.of("Deep", DEFINITIONS, "[".repeat(100_000)).shape().isEmpty());
  }

  @Test
  void commandsAreWrittenInTheFirstEncodingThatTheServerTakes() {
    assertEquals("cdr", CommandFormat.of(List.of("json", "ros1", "cdr"), false, DEFINITIONS).orElseThrow().encoding());
    CommandFormat json = CommandFormat.of(List.of("json", "protobuf"), true, DEFINITIONS).orElseThrow();
    assertEquals(Generation.ROS2, json.generation());
    assertEquals("geometry_msgs/msg/Twist", json.typeName("geometry_msgs/Twist"));
    assertEquals(Optional.empty(), CommandFormat.of(List.of("protobuf"), true, DEFINITIONS));
    Twist twist = new Twist(new Vector3(0.5, 0, 0), new Vector3(0, 0, -1));
    ByteBuffer payload = json.writing(Twist.class, "geometry_msgs/Twist").write(twist);
    assertEquals(twist, JsonFormat.of("geometry_msgs/msg/Twist", DEFINITIONS, "")
        .reading(new MessageForm.Bound<>(Twist.class, false)).read(payload));
    assertThrows(IllegalArgumentException.class, () -> json.trees(Twist.class, "odd_msgs/Odd"));
  }

  @Test
  void whatNobodyCanReadSaysWhy() {
    UnknownFormat format = new UnknownFormat("Odd", "nobody knows flatbuffer");
    assertEquals(Optional.of("nobody knows flatbuffer"), format.obstacle());
    assertEquals("nobody knows flatbuffer",
        assertThrows(IllegalArgumentException.class, () -> format.read(bytes("x"))).getMessage());
  }
}
