package org.robotui.ros.msgs.diagnostic_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * States of parts of a robot ({@code diagnostic_msgs/DiagnosticArray}).
 *
 * @param header time
 * @param status the states
 */
public record DiagnosticArray(Header header, List<DiagnosticStatus> status) {

  /** Between records and bytes. */
  public static final RecordCodec<DiagnosticArray> CODEC =
      RecordCodec.of("diagnostic_msgs/DiagnosticArray", DiagnosticArray::read, DiagnosticArray::write);

  /** Keeps immutable copies of lists. */
  public DiagnosticArray {
    status = List.copyOf(status);
  }

  private static DiagnosticArray read(MessageReader in) throws MessageException {
    return new DiagnosticArray(in.nested("header", Header.CODEC), in.list("status", DiagnosticStatus.CODEC));
  }

  private static void write(DiagnosticArray m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    DiagnosticStatus.CODEC.encodeAll(m.status, out);
  }
}
