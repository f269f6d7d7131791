package org.robotui.ros.msgs.diagnostic_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * State of one part of a robot ({@code diagnostic_msgs/DiagnosticStatus}).
 *
 * @param level      {@link #OK}, {@link #WARN}, {@link #ERROR} or {@link #STALE}
 * @param name       the part
 * @param message    the state in words
 * @param hardwareId the device
 * @param values     details
 */
public record DiagnosticStatus(int level, String name, String message, String hardwareId, List<KeyValue> values) {

  /** The constant {@code OK} of the definition. */
  public static final int OK = 0;
  /** The constant {@code WARN} of the definition. */
  public static final int WARN = 1;
  /** The constant {@code ERROR} of the definition. */
  public static final int ERROR = 2;
  /** The constant {@code STALE} of the definition. */
  public static final int STALE = 3;

  /** Between records and bytes. */
  public static final RecordCodec<DiagnosticStatus> CODEC =
      RecordCodec.of("diagnostic_msgs/DiagnosticStatus", DiagnosticStatus::read, DiagnosticStatus::write);

  /** Keeps immutable copies of lists. */
  public DiagnosticStatus {
    values = List.copyOf(values);
  }

  private static DiagnosticStatus read(MessageReader in) throws MessageException {
    return new DiagnosticStatus(
        in.int8("level"),
        in.string("name"),
        in.string("message"),
        in.string("hardware_id"),
        in.list("values", KeyValue.CODEC));
  }

  private static void write(DiagnosticStatus m, MessageWriter out) {
    out.u8(m.level);
    out.string(m.name);
    out.string(m.message);
    out.string(m.hardwareId);
    KeyValue.CODEC.encodeAll(m.values, out);
  }
}
