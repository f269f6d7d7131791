package org.robotui.rfic.xbot.internal;

import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.CdrWriter;
import org.robotui.message.DefinitionException;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Encoding;
import org.robotui.message.FieldWriter;
import org.robotui.message.Generation;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.topic.RecordedDefinitions;
import org.robotui.xbot.Board;
import org.robotui.xbot.StateFrame;

/**
 * Cycles of a control as messages in CDR, with a definition as ROS 2 has them: memory that is shared has no message of
 * its own, and such ones are read by every tool for recordings. For one thread, but for what it has made.
 */
final class CycleMessages {
  private static final String TYPE = "robotui_msgs/ControlCycle";
  private static final String ENCODING = "cdr";
  private static final String DEFINITION = """
      # A cycle of a control in real time. Element i of each array is of the joint name[i]; SI units, degrees Celsius.
      # References are what went to the hardware, after all limits.
      builtin_interfaces/Time stamp
      uint64 cycle
      # how many cycles before this one were written over before they could be read, since somebody wants them
      uint64 lost
      # 0 well, 1 nothing came in time, 2 fault, 3 an emergency stop is pressed
      uint8 hardware
      string[] name
      float64[] position
      float64[] motor_position
      float64[] velocity
      float64[] motor_velocity
      float64[] effort
      float64[] position_reference
      float64[] velocity_reference
      float64[] effort_reference
      float64[] stiffness
      float64[] damping
      float64[] motor_temperature
      float64[] driver_temperature
      # what of the references is meant: 1 position, 2 velocity, 4 effort, 8 stiffness, 16 damping
      uint8[] mode
      # 0 nobody owns it, 1 its plugin commands it, 2 its plugin missed and it holds, 3 it is safe
      uint8[] control
      uint32[] faults
      # the plugin that owns it
      string[] owner
      """;
  private static final List<ToDoubleFunction<StateFrame.Joint>> NUMBERS = List.of(
      StateFrame.Joint::linkPosition, StateFrame.Joint::motorPosition, StateFrame.Joint::linkVelocity,
      StateFrame.Joint::motorVelocity, StateFrame.Joint::effort, joint -> joint.reference().position(),
      joint -> joint.reference().velocity(), joint -> joint.reference().effort(),
      joint -> joint.reference().stiffness(), joint -> joint.reference().damping(),
      StateFrame.Joint::motorTemperature, StateFrame.Joint::driverTemperature);

  private final String topic;
  private final MessageSchema schema;
  private final RawDefinition definition;
  private final CdrWriter out = new CdrWriter();

  CycleMessages(String topic) {
    this.topic = topic;
    try {
      schema = MessageSchema.parse(TYPE, DEFINITION, Generation.ROS2);
    } catch (DefinitionException e) {
      throw new IllegalStateException("a definition of our own cannot be read", e);
    }
    definition = RecordedDefinitions.of(schema, Encoding.CDR);
  }

  /**
   * A cycle as a message.
   *
   * @param lost how many cycles were missed so far
   */
  RawMessage of(Board board, StateFrame state, long stampNanos, long lost) {
    out.clear();
    out.stamp(stampNanos).i64(state.cycle()).i64(lost).u8(state.hardware().ordinal());
    int count = Math.min(board.joints().size(), state.joints().size());
    List<StateFrame.Joint> joints = state.joints().subList(0, count);
    texts(board.joints().subList(0, count).stream().map(Board.Joint::name).toList());
    NUMBERS.forEach(number -> {
      out.array(count);
      joints.forEach(joint -> out.f64(number.applyAsDouble(joint)));
    });
    out.array(count);
    joints.forEach(joint -> out.u8(joint.mode()));
    out.array(count);
    joints.forEach(joint -> out.u8(joint.control().ordinal()));
    out.array(count);
    joints.forEach(joint -> out.i32((int) joint.faults()));
    texts(joints.stream().map(joint -> owner(board, joint)).toList());
    byte[] bytes = new byte[out.size()];
    out.view().get(bytes);
    return new RawMessage(TYPE, ENCODING, Bytes.wrap(bytes, 0, bytes.length), this::read,
        new RawOrigin(topic, board.robot(), false, () -> Optional.of(definition)));
  }

  private void texts(List<String> texts) {
    FieldWriter to = out.array(texts.size());
    texts.forEach(to::string);
  }

  static String owner(Board board, StateFrame.Joint joint) {
    return IntStream.of(joint.owner()).filter(i -> i >= 0 && i < board.plugins().size())
        .mapToObj(i -> board.plugins().get(i).name()).findFirst().orElse("");
  }

  private Optional<DynamicRecord> read(Bytes bytes) {
    try {
      return Optional.of(new MessageRecord(
          DynamicMessage.read(schema, Encoding.CDR.reader(bytes.buffer(ByteOrder.LITTLE_ENDIAN)))));
    } catch (MessageException e) {
      return Optional.empty();
    }
  }
}
