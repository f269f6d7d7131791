package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

import org.junit.jupiter.api.Test;

class DynamicMessageTest {

  private static final String EMPTY_ARRAYS = "E[] many\nuint8 last\n===\nMSG: p/E\n";

  private final DynamicCodec odometry = new DynamicCodec(ShippedDefinitions.schema("nav_msgs/Odometry"));
  private final DynamicCodec scan = new DynamicCodec(ShippedDefinitions.schema("sensor_msgs/LaserScan"));
  private final DynamicCodec cloud = new DynamicCodec(ShippedDefinitions.schema("sensor_msgs/PointCloud"));

  @Test
  void nestedFieldsAreFoundByPath() throws Exception {
    DynamicMessage m = odometry.build(Map.of(
        "header", Map.of("stamp", Map.of("secs", 7, "nsecs", 5), "frame_id", "odom"),
        "pose", Map.of("pose", Map.of("position", Map.of("x", 1.5)), "covariance", new double[36])));
    assertEquals(OptionalDouble.of(1.5), m.number("pose.pose.position.x"));
    assertEquals("odom", m.text("header.frame_id").orElseThrow());
    assertEquals(new RosValue.Instant(7_000_000_005L, Primitive.TIME), m.at("header.stamp").orElseThrow());
    assertEquals(OptionalDouble.of(5), m.number("header.stamp.nsecs"));
    assertEquals(36, assertInstanceOf(RosValue.Numbers.class, m.at("pose.covariance").orElseThrow())
        .values().size());
  }

  @Test
  void arrayElementsAreFoundByIndex() throws Exception {
    DynamicMessage m = scan.build(Map.of("ranges", new float[]{1, 2, Float.NaN, 4}));
    assertEquals(OptionalDouble.of(4), m.number("ranges[3]"));
    assertTrue(Double.isNaN(m.number("ranges[2]").orElseThrow()));
    DynamicMessage c = cloud.build(Map.of(
        "points", List.of(Map.of("x", 1), Map.of("y", "2.5")),
        "channels", List.of(Map.of("name", "a", "values", List.of(1, 2)), Map.of("name", "b"))));
    assertEquals(OptionalDouble.of(2.5), c.number("points[1].y"));
    assertEquals("b", c.text("channels[1].name").orElseThrow());
    assertEquals(OptionalDouble.of(2), c.number("channels[0].values[1]"));
  }

  @Test
  void pathsThatLeadNowhereAnswerNothing() throws Exception {
    DynamicMessage m = scan.build(Map.of("ranges", new float[]{1}));
    for (String path : List.of("nothing", "ranges[1]", "ranges.x", "ranges[", "header.", "header..seq",
        "[0]", "header[0]", "ranges[0][0]", ".header", "header.stamp.hours")) {
      assertTrue(m.at(path).isEmpty(), path);
    }
    assertTrue(m.number("header.frame_id").isEmpty());
    assertTrue(m.text("header.seq").isEmpty());
  }

  @Test
  void unsignedNumbersKeepTheirValue() throws Exception {
    DynamicCodec codec = new DynamicCodec(MessageSchema.parse("p/T", "uint64 big\nuint8[] small\nint8 minus"));
    DynamicMessage m = codec.build(
        Map.of("big", "18446744073709551615", "small", new byte[]{-1, 1}, "minus", -3));
    assertEquals("18446744073709551615", ((RosValue.Whole) m.at("big").orElseThrow()).text());
    assertEquals(18446744073709551615.0, m.number("big").orElseThrow());
    assertEquals(255, m.number("small[0]").orElseThrow());
    assertEquals(-3, m.number("minus").orElseThrow());
  }

  @Test
  void aMessageIsRebuiltFromItsOwnValues() throws Exception {
    DynamicMessage m = cloud.build(Map.of("points", List.of(Map.of("x", 1)),
        "channels", List.of(Map.of("name", "a", "values", new float[]{3}))));
    Map<String, RosValue> values = new HashMap<>();
    m.fields().forEach(f -> values.put(f.name(), m.field(f.name()).orElseThrow()));
    assertEquals(m, cloud.build(values));
    PrimitiveArray numbers = ((RosValue.Numbers) m.at("channels[0].values").orElseThrow()).values();
    assertArrayEquals(new double[]{3}, numbers.toDoubles());
  }

  @Test
  void valuesThatDoNotFitAreRefusedWithTheirPath() {
    refused(Map.of("header", Map.of("seq", -1)), "the number -1 is no uint32", "header.seq");
    refused(Map.of("header", Map.of("seq", 1.5)), "the number 1.5 is no uint32", "header.seq");
    refused(Map.of("ranges", 3), "expected float32[], got the number 3", "ranges");
    refused(Map.of("ranges", List.of(1, "x")), "the text 'x' is no float32", "ranges[1]");
    refused(Map.of("header", 3), "expected std_msgs/Header, got the number 3", "header");
    refused(Map.of("header", Map.of("stamp", -1)), "the number -1 is no time", "header.stamp");
    refused(Map.of("header", Map.of("frame", "x")),
        "std_msgs/Header has no field 'frame'; it has seq, stamp, frame_id", "header");
    MessageException e = assertThrows(MessageException.class,
        () -> odometry.build(Map.of("pose", Map.of("covariance", List.of(1)))));
    assertEquals("expected 36 values, got 1", e.problem());
  }

  private void refused(Map<String, ?> values, String problem, String path) {
    MessageException e = assertThrows(MessageException.class, () -> scan.build(values));
    assertEquals(problem, e.problem());
    assertEquals(path, e.path());
  }

  @Test
  void aLengthBeyondTheMessageIsRefusedWithFieldAndOffset() throws Exception {
    byte[] bytes = new byte[scan.build(Map.of()).bytes().remaining()];
    ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(bytes.length - 8, 0x7fffffff);
    MessageException e = assertThrows(MessageException.class, () -> scan.decode(ByteBuffer.wrap(bytes)));
    assertEquals("a length of 2147483647 does not fit into the remaining 4 bytes in field ranges at byte "
        + (bytes.length - 8), e.getMessage());
  }

  @Test
  void arraysOfNothingAreBounded() throws Exception {
    DynamicCodec codec = new DynamicCodec(MessageSchema.parse("p/T", EMPTY_ARRAYS));
    DynamicMessage three = codec.decode(ByteBuffer.wrap(new byte[]{3, 0, 0, 0, 9}));
    assertEquals(9, three.number("last").orElseThrow());
    assertEquals(3, ((RosValue.Messages) three.at("many").orElseThrow()).values().size());
    byte[] lying = {-1, -1, -1, -1, 9};
    assertThrows(MessageException.class, () -> codec.decode(ByteBuffer.wrap(lying)));
    assertThrows(DefinitionException.class,
        () -> MessageSchema.parse("p/T", "E[999999999] many\n===\nMSG: p/E\n"));
  }

  @Test
  void aFixedArrayThatCannotBeThereIsRefusedBeforeItIsAllocated() throws Exception {
    DynamicCodec codec = new DynamicCodec(MessageSchema.parse("p/T", "float64[900000000] many"));
    MessageException e =
        assertThrows(MessageException.class, () -> codec.decode(ByteBuffer.wrap(new byte[64])));
    assertEquals("many", e.path());
  }

  @Test
  void bytesAndTimesAreTakenAsJsonHasThem() throws DefinitionException, MessageException {
    DynamicCodec codec = new DynamicCodec(MessageSchema.parse("a/B", "uint8[] data\ntime stamp\n"));
    Map<String, Object> values = Map.of("data", "AQL/", "stamp", Map.of("sec", 3, "nsec", 4));
    DynamicMessage message = codec.build(values);
    assertEquals(255, message.number("data[2]").orElseThrow());
    assertEquals(codec.build(Map.of("data", new byte[]{1, 2, -1}, "stamp", 3_000_000_004L)), message);
    assertThrows(MessageException.class, () -> codec.build(Map.of("data", "no Base64!")));
  }
}
