package org.robotui.message.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.marker.MarkerSet;
import org.robotui.message.CdrReader;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageException;
import org.robotui.message.MessageReader;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.RecordBinding;
import org.robotui.message.SchemaLookup;
import org.robotui.testkit.recorded.BagReader;
import org.robotui.testkit.recorded.SharedData;

/** The same message in the serialization of ROS 1 and in CDR becomes the same data by the same adapter. */
class EncodingsTest {
  private static final FrameNames NAMES = new FrameNames("robby", ClockKind.ROBOT);
  private static final Path VECTORS =
      Path.of("..", "org.robotui.message", "src_test", "org", "robotui", "message", "cdr_vectors.txt").toAbsolutePath()
          .normalize();

  private final Adapters adapters = new Adapters();

  /** What rosbags wrote: the first of each type that both generations have. */
  static List<String[]> vectors() throws IOException {
    Map<String, String[]> byType = new LinkedHashMap<>();
    Files.readAllLines(VECTORS).stream().filter(line -> !line.startsWith("#")).map(line -> line.split(" "))
        .filter(parts -> !parts[1].equals("-") && !parts[1].equals("."))
        .forEach(parts -> byType.putIfAbsent(parts[0], parts));
    return List.copyOf(byType.values());
  }

  @ParameterizedTest
  @MethodSource("vectors")
  void whatAnIndependentPeerWroteInBothIsTheSame(String type, String ros1, String little, String big) throws Exception {
    Object expected = read(type, ros1, Generation.ROS1);
    assertEquals(expected, read(type, little, Generation.ROS2), type);
    assertEquals(expected, read(type, big, Generation.ROS2), type);
  }

  private Object read(String type, String hex, Generation generation) throws MessageException {
    return convert(adapters.of(type), ByteBuffer.wrap(HexFormat.of().parseHex(hex)), generation);
  }

  /** The value, or why the adapter refuses the message: random values are not always data. */
  private static <M, D extends Data> Object convert(Adapter<M, D> adapter, ByteBuffer bytes, Generation generation)
      throws MessageException {
    try {
      Optional<D> value = adapter.convert().apply(message(adapter, bytes, generation), NAMES);
      return value.<Object>map(EncodingsTest::comparable).orElse("nothing");
    } catch (IllegalArgumentException e) {
      return String.valueOf(e.getMessage());
    }
  }

  /** Markers know when they came; of records whatever their type has in both generations. */
  private static Object comparable(Data data) {
    return switch (data) {
      case MarkerSet set -> set.entries().stream()
          .map(e -> e.marker().map(m -> List.of(m.pose(), m.scale(), m.points(), m.text()))).toList();
      case MessageRecord record -> record.fields().stream().filter(name -> !name.equals("header")).map(record::field)
          .toString().length() > 0;
      default -> data;
    };
  }

  @SuppressWarnings("unchecked") // the messages of each form are of its own type
  static <M> M message(Adapter<M, ?> adapter, ByteBuffer bytes, Generation generation) throws MessageException {
    return switch (adapter.form()) {
      case MessageForm.Bound<?> bound -> (M) RecordBinding.shipped(bound.type(), generation).decode(bytes);
      case MessageForm.Dynamic any -> (M) DynamicMessage.read(schema(adapter.type(), generation),
          generation == Generation.ROS1 ? new MessageReader(bytes) : new CdrReader(bytes));
      case MessageForm.ByFields any -> throw new AssertionError(adapter.type() + " is recorded nowhere");
    };
  }

  static MessageSchema schema(String type, Generation generation) {
    MessageRegistry registry = new MessageRegistry(new LocalDefinitions(List.of(), List.of(), generation), generation);
    return ((SchemaLookup.Found<MessageSchema>) registry.message(type)).schema();
  }

  @ParameterizedTest
  @ValueSource(strings = {"sena_loop.bag", "husky_imu_gps_odom.bag", "tiago_joint_states.bag", "lidar_clouds.bag",
      "stereo_jpeg.bag"})
  @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
  void recordedMessagesAreTheSameInCdr(String bag) throws Exception {
    Map<String, BagReader.Recorded> byType = new LinkedHashMap<>();
    BagReader.read(SharedData.file("bags/" + bag)).forEach(m -> byType.putIfAbsent(m.type(), m));
    int compared = 0;
    for (BagReader.Recorded each : byType.values()) {
      compared += adapters.of(each.type()).form() instanceof MessageForm.Bound<?> bound && compare(bound, each) ? 1 : 0;
    }
    assertTrue(compared > 0, bag);
  }

  private <M extends Record> boolean compare(MessageForm.Bound<M> bound, BagReader.Recorded recorded)
      throws MessageException {
    M message = RecordBinding.shipped(bound.type(), Generation.ROS1).decode(recorded.bytes().duplicate());
    ByteBuffer cdr = RecordBinding.shipped(bound.type(), Generation.ROS2).encode(message);
    Adapter<?, ?> adapter = adapters.of(recorded.type());
    assertEquals(convert(adapter, recorded.bytes().duplicate(), Generation.ROS1),
        convert(adapter, cdr, Generation.ROS2), recorded.type());
    return true;
  }

  @Test
  void theTwoKindsOfLogEntriesAreOneKindOfData() {
    String type = "rcl_interfaces/Log";
    assertEquals(adapters.of("rosgraph_msgs/Log").data(), adapters.of(type).data());
  }
}
