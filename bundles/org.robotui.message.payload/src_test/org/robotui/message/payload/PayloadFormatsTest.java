package org.robotui.message.payload;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.message.Generation;
import org.robotui.message.data.MessageForm;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.sensor_msgs.Range;

class PayloadFormatsTest {
  private static final String IDL = "=".repeat(80) + "\nIDL: odd_msgs/msg/Part\n"
      + "module odd_msgs { module msg { struct Part { float size; sequence<octet> raw; }; }; };\n";

  private final RosDefinitions definitions = new RosDefinitions(Map.of());
  private final PayloadFormats formats = new PayloadFormats(definitions);

  private PayloadFormat format(String encoding, String type, String schemaEncoding, String schema) {
    return formats.of(new PayloadSource(encoding, type, schemaEncoding, schema));
  }

  private static ByteBuffer json(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
  }

  private static double number(DynamicRecord record, String path) {
    return ((FieldValue.Num) record.at(FieldPath.parse(path)).orElseThrow()).value();
  }

  @Test
  void typesOfRosAreReadByTheDefinitionThatCame() {
    PayloadFormat one = format("ros1", "odd_msgs/Part", "ros1msg", "float32 size\nuint8[] raw\n");
    PayloadFormat two = format("cdr", "odd_msgs/msg/Part", "ros2msg", "float32 size\nuint8[] raw\n");
    PayloadFormat idl = format("cdr", "odd_msgs/msg/Part", "ros2idl", IDL);
    for (PayloadFormat each : List.of(one, two, idl)) {
      assertEquals("odd_msgs/Part", each.type());
      ByteBuffer written = each.write(Map.of("size", 2.5, "raw", "AQI="));
      assertEquals(2.5, number(each.read(written), "size"));
      assertEquals("size", each.shape().orElseThrow().fields().getFirst().name());
    }
    assertEquals(two.write(Map.of("size", 1)), idl.write(Map.of("size", 1)));
  }

  @Test
  void whereNoDefinitionCameTheShippedOneIsTaken() {
    PayloadFormat twist = format("cdr", "geometry_msgs/msg/Twist", "", "");
    ByteBuffer written = twist.write(Map.of("linear", Map.of("x", 0.5)));
    assertEquals(new Twist(new Vector3(0.5, 0, 0), new Vector3(0, 0, 0)),
        twist.reading(new MessageForm.Bound<>(Twist.class, false)).read(written));
    assertTrue(format("ros1", "odd_msgs/Part", "", "").obstacle().orElseThrow().contains("odd_msgs/Part"));
    assertTrue(format("ros1", "std_msgs/Empty", "ros1msg", "").obstacle().isEmpty());
  }

  @Test
  void jsonOfATypeOfRosIsReadByItsDefinition() {
    PayloadFormat scan = format("json", "sensor_msgs/LaserScan", "jsonschema", "{}");
    LaserScan read = scan.reading(new MessageForm.Bound<>(LaserScan.class, false)).read(json("{\"header\":"
        + "{\"seq\":1,\"stamp\":{\"secs\":2,\"nsecs\":3},\"frame_id\":\"l\"},\"ranges\":[1,null,2.5]}"));
    assertEquals(2_000_000_003L, read.header().stamp());
    assertTrue(Float.isNaN(read.ranges()[1]) && read.ranges()[2] == 2.5f);
    PayloadFormat second = format("json", "sensor_msgs/msg/Range", "", "");
    assertEquals(7_000_000_000L, second.reading(new MessageForm.Bound<>(Range.class, false))
        .read(json("{\"header\":{\"stamp\":{\"sec\":7,\"nanosec\":0}}}")).header().stamp());
    assertThrows(IllegalArgumentException.class, () -> second.read(json("{\"nonsense\":1}")));
  }

  @Test
  void otherJsonIsARecordWithTheFormThatItsSchemaSays() {
    PayloadFormat odd = format("json", "Battery", "jsonschema", "{\"type\":\"object\",\"properties\":{\"percent\":"
        + "{\"type\":\"number\"},\"cells\":{\"type\":\"array\",\"items\":{\"type\":\"integer\"}}}}");
    assertTrue(odd.definition().isEmpty());
    assertEquals(new FieldShape.Many(new FieldShape.Whole(64, true), 0),
        odd.shape().orElseThrow().field("cells").orElseThrow().shape());
    DynamicRecord record = odd.read(json("{\"percent\":80.5,\"cells\":[1,2],\"a\":[{\"b\":7}],\"none\":null}"));
    assertEquals(80.5, number(record, "percent"));
    assertEquals(2, number(record, "cells[1]"));
    assertEquals(7, number(record, "a[0].b"));
    assertTrue(record.field("none").isEmpty());
    assertEquals(3, number(odd.read(json("3")), "value"));
    assertThrows(IllegalArgumentException.class, () -> odd.read(json("{")));
    assertThrows(IllegalArgumentException.class, () -> odd.reading(new MessageForm.Dynamic()));
  }

  @Test
  void whatNobodyCanReadIsNamedWithItsReason() {
    PayloadFormat odd = format("msgpack", "Odd", "", "");
    assertEquals("Odd in msgpack: this encoding is none that is known here (ros1, cdr, json, protobuf)",
        odd.obstacle().orElseThrow());
    for (String[] each : new String[][]{{"protobuf", "a.B", "protobuf", "!"}, {"protobuf", "a.B", "protobuf", ""},
        {"cdr", "a/msg/B", "ros2idl", "module {"}, {"ros1", "a/B", "ros1msg", "nonsense"}}) {
      assertTrue(format(each[0], each[1], each[2], each[3]).obstacle().isPresent(), each[0] + " " + each[3]);
    }
  }

  @Test
  void damagedSchemasAndMessagesAreRefusedAndNothingElse() {
    Random random = new Random(8);
    PayloadFormat part = format("cdr", "odd_msgs/msg/Part", "ros2idl", IDL);
    byte[] message = new byte[part.write(Map.of("size", 1, "raw", "AQID")).remaining()];
    part.write(Map.of("size", 1, "raw", "AQID")).get(message);
    int refused = 0;
    for (int i = 0; i < 3000; i++) {
      StringBuilder schema = new StringBuilder(IDL);
      schema.setCharAt(random.nextInt(schema.length()), (char) random.nextInt(128));
      refused += format("cdr", "odd_msgs/msg/Part", "ros2idl", schema.toString()).obstacle().isPresent() ? 1 : 0;
      byte[] bad = message.clone();
      bad[random.nextInt(bad.length)] = (byte) random.nextInt();
      try {
        part.read(ByteBuffer.wrap(bad, 0, random.nextInt(bad.length + 1)));
      } catch (IllegalArgumentException e) {
        refused++;
      }
    }
    assertTrue(refused > 1000, "only " + refused);
  }

  @Test
  void commandsAreWrittenInWhatTheServerTakes() {
    Twist twist = new Twist(new Vector3(0.5, 0, 0), new Vector3(0, 0, -1));
    CommandFormat cdr = CommandFormat.of(List.of("json", "cdr"), false, definitions).orElseThrow();
    assertEquals("geometry_msgs/msg/Twist", cdr.typeName("geometry_msgs/Twist"));
    assertTrue(cdr.schema("geometry_msgs/Twist").contains("linear") && cdr.schemaEncoding().equals("ros2msg"));
    assertEquals(52, cdr.writing(Twist.class, "geometry_msgs/Twist").write(twist).remaining());
    CommandFormat json = CommandFormat.of(List.of("json"), true, definitions).orElseThrow();
    assertEquals(Generation.ROS2, json.generation());
    assertEquals("{\"linear\":{\"x\":0.5,\"y\":0.0,\"z\":0.0},\"angular\":{\"x\":0.0,\"y\":0.0,\"z\":-1.0}}",
        StandardCharsets.UTF_8.decode(json.writing(Twist.class, "geometry_msgs/Twist").write(twist)).toString());
    assertTrue(CommandFormat.of(List.of("protobuf"), false, definitions).isEmpty());
  }
}
