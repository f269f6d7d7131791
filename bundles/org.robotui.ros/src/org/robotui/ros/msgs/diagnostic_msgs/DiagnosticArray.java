package org.robotui.ros.msgs.diagnostic_msgs;

import java.util.List;

import org.robotui.ros.message.MessageType;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * States of parts of a robot ({@code diagnostic_msgs/DiagnosticArray}).
 *
 * @param header time
 * @param status the states
 */
@MessageType("diagnostic_msgs/DiagnosticArray")
public record DiagnosticArray(Header header, List<DiagnosticStatus> status) {

  /** Keeps immutable copies of lists. */
  public DiagnosticArray {
    status = List.copyOf(status);
  }
}
