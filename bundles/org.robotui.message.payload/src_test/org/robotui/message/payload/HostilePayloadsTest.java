package org.robotui.message.payload;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.message.Encoding;
import org.robotui.message.data.MessageForm;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.Effort;

/** Payloads that no honest server sends: each is read, or refused with a reason, and nothing else happens. */
class HostilePayloadsTest {
  private static final RosDefinitions DEFINITIONS = new RosDefinitions(Map.of());
  private static final List<String> TYPES = List.of("sensor_msgs/LaserScan", "nav_msgs/Odometry",
      "sensor_msgs/PointCloud2", "tf2_msgs/TFMessage", "nav_msgs/OccupancyGrid", "sensor_msgs/JointState");
  private static final Map<String, Object> FIELDS = Map.of("header", Map.of("frame_id", "laser"));

  private int read;
  private int refused;

  /** Messages of one format, which are damaged. */
  private record Payload(PayloadFormat format, byte[] bytes) {}

  private static Map<String, Object> fields(String type) {
    return switch (type) {
      case "sensor_msgs/LaserScan" -> with("ranges", List.of(1, 2, 3, 4.5));
      case "sensor_msgs/PointCloud2" -> with("data", List.of(1, 2, 3, 4), "fields",
          List.of(Map.of("name", "x", "offset", 0, "datatype", 7, "count", 1)));
      case "tf2_msgs/TFMessage" -> Map.of("transforms", List.of(FIELDS, Map.of("child_frame_id", "base")));
      case "nav_msgs/OccupancyGrid" -> with("data", List.of(0, 100, -1));
      case "sensor_msgs/JointState" -> with("name", List.of("a", "bc"), "position", List.of(1.5, 2.5));
      default -> FIELDS;
    };
  }

  private static Map<String, Object> with(Object... more) {
    Map<String, Object> all = new HashMap<>(FIELDS);
    for (int i = 0; i < more.length; i += 2) {
      all.put((String) more[i], more[i + 1]);
    }
    return all;
  }

  private static Stream<Payload> payloads(String type) {
    PayloadFormat cdr = new RosFormat(DEFINITIONS.find(type.replace("/", "/msg/")).orElseThrow(), Encoding.CDR);
    PayloadFormat one = new RosFormat(DEFINITIONS.find(type).orElseThrow(), Encoding.ROS1);
    PayloadFormat json = JsonFormat.of(type, DEFINITIONS, "");
    PayloadFormat free = JsonFormat.of("Free", DEFINITIONS, "");
    return Stream.of(cdr, one, json, free).map(format -> new Payload(format, bytes(format.write(fields(type)))));
  }

  private static byte[] bytes(ByteBuffer buffer) {
    byte[] bytes = new byte[buffer.remaining()];
    buffer.duplicate().get(bytes);
    return bytes;
  }

  private void read(PayloadFormat format, byte[] bytes) {
    try {
      walk(format.read(ByteBuffer.wrap(bytes)));
      if (format.definition().isPresent()) {
        format.reading(new MessageForm.Dynamic()).read(ByteBuffer.wrap(bytes));
      }
      read++;
    } catch (IllegalArgumentException e) {
      refused++;
      assertTrue(e.getMessage() != null && e.getMessage().length() < 1000, e.getMessage());
    }
  }

  private static void walk(DynamicRecord record) {
    for (String name : record.fields()) {
      if (record.field(name).orElse(null) instanceof FieldValue.Nested nested) {
        walk(nested.value());
      }
    }
  }

  @Test
  void payloadsMayBeDamagedAnyhow() {
    List<Payload> all = new ArrayList<>();
    TYPES.forEach(type -> payloads(type).forEach(all::add));
    all.forEach(each -> read(each.format(), each.bytes()));
    assertTrue(read == all.size() && refused == 0, refused + " honest ones were refused");
    ByteMutator mutator = new ByteMutator(Effort.seed());
    Effort effort = Effort.of(30_000, Duration.ofMinutes(3));
    while (effort.goesOn()) {
      Payload each = all.get(mutator.random().nextInt(all.size()));
      read(each.format(), mutator.mutate(each.bytes()));
    }
    assertTrue(read > effort.rounds() / 10 && refused > effort.rounds() / 10, read + " read, " + refused + " refused");
  }

  @Test
  void payloadsMayEndAnywhere() {
    TYPES.forEach(type -> payloads(type).forEach(each -> {
      for (int length = 0; length < each.bytes().length; length++) {
        read(each.format(), Arrays.copyOf(each.bytes(), length));
      }
    }));
    assertTrue(refused > read, read + " read, " + refused + " refused");
  }
}
