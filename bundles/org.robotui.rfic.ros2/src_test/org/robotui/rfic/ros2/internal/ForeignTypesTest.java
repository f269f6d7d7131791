package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.sensor.Battery;
import org.robotui.message.Definitions;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageSchema;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Publisher;

/** Types that are not shipped, or are in another version. */
class ForeignTypesTest extends Ros2Case {
  private static final Deque<String> NOTHING = new ArrayDeque<>();

  @TempDir
  Path folder;

  private Ros2Publisher<DynamicMessage> publisher(String type, MessageSchema schema) {
    return robot.publisher("thing", Ros2Codec.of(TypeName.parse(type).orElseThrow(), schema), QosProfiles.LATCHED);
  }

  private void wanted() {
    await(() -> context.streams.containsKey("thing"));
    context.demand("thing", true);
  }

  @Test
  void whatNobodyDescribesIsSaidWithWhatWouldHelpAndKeptMessagesComeOnceAFolderHasIt() throws Exception {
    MessageSchema odd = MessageSchema.parse("odd_msgs/Odd", "uint8 odd\n", Generation.ROS2);
    publisher("odd_msgs/msg/Odd", odd).publish(new DynamicCodec(odd).build(Map.of("odd", 7)));
    rfic(context, Map.of("types", List.of(folder.toString()))).start();
    wanted();
    await(() -> context.complaints.getOrDefault("thing", NOTHING).stream()
        .anyMatch(said -> said.contains("no definition of odd_msgs/msg/Odd") && said.contains("odd_msgs here")));
    Path inside = Files.createDirectories(folder.resolve("odd_msgs/msg"));
    Files.writeString(folder.resolve("odd_msgs/package.xml"), "<package/>");
    Files.writeString(inside.resolve("Odd.msg"), "uint8 odd\n");
    DynamicRecord record = (DynamicRecord) first("thing").value();
    assertEquals(Optional.of(new FieldValue.Num(7, "7")), record.at(FieldPath.parse("odd")));
  }

  @Test
  void aVersionThatHasOneFieldMoreIsReadByItsDefinition() throws Exception {
    Path inside = Files.createDirectories(folder.resolve("sensor_msgs/msg"));
    Files.writeString(folder.resolve("sensor_msgs/package.xml"), "<package/>");
    String text = Definitions.shipped(Generation.ROS2).find("sensor_msgs/BatteryState").orElseThrow().text();
    Files.writeString(inside.resolve("BatteryState.msg"), text + "\nuint8 more\n");
    LocalDefinitions changed = LocalDefinitions.ofRos2(List.of(folder), Map.of());
    MessageSchema more = MessageSchema.resolve(changed.find("sensor_msgs/BatteryState").orElseThrow(),
        Definitions.shipped(Generation.ROS2));
    publisher("sensor_msgs/msg/BatteryState", more)
        .publish(new DynamicCodec(more).build(Map.of("percentage", 0.25, "present", true, "more", 3)));
    rfic(context, Map.of("types", List.of(folder.toString()))).start();
    wanted();
    Battery battery = (Battery) first("thing").value();
    assertEquals(0.25, battery.charge(), 1e-6);
    DynamicRecord message = first("thing").raw().orElseThrow().record().orElseThrow();
    assertTrue(message.fields().contains("more"));
  }
}
