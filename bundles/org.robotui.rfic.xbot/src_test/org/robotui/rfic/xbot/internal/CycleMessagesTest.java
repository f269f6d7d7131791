package org.robotui.rfic.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Encoding;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;
import org.robotui.message.data.MessageRecord;
import org.robotui.xbot.Board;
import org.robotui.xbot.StateFrame;

class CycleMessagesTest {
  private static final StateFrame.Joint PAN = new StateFrame.Joint(0.5, 0.6, 1, 2, 3,
      new StateFrame.Reference(0.25, 0, 0, 100, 1), 25, 40, Double.NaN, 0x80000001L, 2, 1, 0,
      StateFrame.Control.COMMANDED);
  private static final Board BOARD = new Board("arm", "dummy", true, 0,
      List.of(new Board.Joint("pan", 1, false, -1, 1, 2, 80), new Board.Joint("lift", 2, true, 0, 0.5, 0.1, 200)),
      List.of(), List.of(), List.of(), List.of(new Board.Plugin("homing", "Homing", 0, 0, Board.PluginState.RUNNING, 3,
          false, "", "")),
      List.of());

  private static RawMessage message(List<StateFrame.Joint> joints) {
    return new CycleMessages("cycles").of(BOARD,
        new StateFrame(7, 1, StateFrame.Hardware.TIMEOUT, joints, List.of(), List.of()), 1_500_000_000L, 3);
  }

  private static double number(DynamicRecord record, String path) {
    return record.number(FieldPath.parse(path)).orElseThrow();
  }

  @Test
  void aCycleIsReadByItsDefinitionAlone() throws Exception {
    RawMessage message = message(List.of(PAN, PAN));
    RawDefinition definition = message.origin().definition().get().orElseThrow();
    byte[] text = new byte[definition.content().size()];
    definition.content().copyTo(0, text, 0, text.length);
    MessageSchema schema = MessageSchema.parse("robotui_msgs/ControlCycle", new String(text, StandardCharsets.UTF_8),
        Generation.ROS2);
    DynamicRecord read = new MessageRecord(DynamicMessage.read(schema,
        Encoding.CDR.reader(message.bytes().buffer(ByteOrder.LITTLE_ENDIAN))));

    assertEquals("robotui_msgs/msg/ControlCycle", definition.name());
    assertEquals(new FieldValue.Time(1_500_000_000L), read.field("stamp").orElseThrow());
    assertEquals(List.of(7.0, 3.0, 1.0, 0.5, 3.0, 0.25, 100.0, 25.0, 1.0, 2147483649.0),
        List.of("cycle", "lost", "hardware", "position[1]", "effort[0]", "position_reference[0]", "stiffness[1]",
            "mode[0]", "control[1]", "faults[1]").stream().map(path -> number(read, path)).toList());
    assertEquals(List.of("pan", "lift"), texts(read, "name"));
    assertEquals(List.of("homing", "homing"), texts(read, "owner"));
  }

  private static List<String> texts(DynamicRecord record, String field) {
    return ((FieldValue.Items) record.field(field).orElseThrow()).values().stream()
        .map(each -> ((FieldValue.Text) each).value()).toList();
  }

  @Test
  void aStateOfFewerJointsThanTheBoardIsCutToThem() {
    DynamicRecord read = message(List.of(PAN)).record().orElseThrow();
    assertEquals(List.of("pan"), texts(read, "name"));
    assertEquals(0.5, number(read, "position[0]"));
  }
}
