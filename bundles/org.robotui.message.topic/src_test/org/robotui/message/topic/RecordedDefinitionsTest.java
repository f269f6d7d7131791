package org.robotui.message.topic;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.RawDefinition;
import org.robotui.message.Encoding;
import org.robotui.message.Generation;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageSchema;

class RecordedDefinitionsTest {
  private static final String RULE = "=".repeat(80) + "\n";

  private static String text(RawDefinition definition) {
    return StandardCharsets.UTF_8.decode(definition.content().buffer(ByteOrder.LITTLE_ENDIAN)).toString();
  }

  @Test
  void aTypeOfRos2IsWrittenInItsOwnWordsAlthoughItWasReadFromThoseOfRos1() throws Exception {
    MessageSchema schema = MessageSchema.parse("demo_msgs/Walk", """
        # how it walks
        uint8 SLOW=1
        Header header
        duration[] steps
        Foot[2] feet
        string<=10 name "none"
        """ + RULE + "MSG: demo_msgs/Foot\nfloat64 z\n" + RULE + "MSG: std_msgs/Header\ntime stamp\nstring frame_id\n",
        Generation.ROS2);

    RawDefinition definition = RecordedDefinitions.of(schema, Encoding.CDR);

    assertEquals("demo_msgs/msg/Walk", definition.name());
    assertEquals("ros2msg", definition.encoding());
    assertEquals("""
        uint8 SLOW=1
        std_msgs/Header header
        builtin_interfaces/Duration[] steps
        demo_msgs/Foot[2] feet
        string<=10 name "none"
        """ + RULE + "MSG: demo_msgs/Foot\nfloat64 z\n" + RULE
        + "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + RULE
        + "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + RULE
        + "MSG: builtin_interfaces/Duration\nint32 sec\nuint32 nanosec\n", text(definition));
    assertEquals(schema.minSize(),
        MessageSchema.parse("demo_msgs/Walk", text(definition), Generation.ROS2).minSize());
  }

  @Test
  void theSameForMessagesThatCameAsRos1() throws Exception {
    MessageSchema schema = MessageSchema.parse("demo_msgs/Walk", "builtin_interfaces/Time at\nfloat64[<=3] z\n",
        Generation.ROS2);

    RawDefinition definition = RecordedDefinitions.of(schema, Encoding.ROS1);

    assertEquals("demo_msgs/Walk", definition.name());
    assertEquals("ros1msg", definition.encoding());
    assertEquals("time at\nfloat64[] z\n", text(definition));
  }

  @Test
  void whatAPublisherAnnouncedIsKeptToTheLetter() {
    String announced = "# odd\nfloat64   z\n";

    assertEquals(announced,
        text(RecordedDefinitions.announced(new MessageInfo("demo_msgs/Foot", "*", announced)).orElseThrow()));
    assertEquals(Optional.empty(), RecordedDefinitions.announced(new MessageInfo("demo_msgs/Foot", "*", "")));
  }
}
