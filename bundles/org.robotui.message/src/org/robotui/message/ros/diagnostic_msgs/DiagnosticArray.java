package org.robotui.message.ros.diagnostic_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

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
