package org.robotui.message.ros.diagnostic_msgs;

import java.util.List;

import org.robotui.message.MessageType;

/**
 * State of one part of a robot ({@code diagnostic_msgs/DiagnosticStatus}).
 *
 * @param level {@link #OK}, {@link #WARN}, {@link #ERROR} or {@link #STALE}
 * @param name the part
 * @param message the state in words
 * @param hardwareId the device
 * @param values details
 */
@MessageType("diagnostic_msgs/DiagnosticStatus")
public record DiagnosticStatus(int level, String name, String message, String hardwareId, List<KeyValue> values) {

  /** The constant {@code OK} of the definition. */
  public static final int OK = 0;
  /** The constant {@code WARN} of the definition. */
  public static final int WARN = 1;
  /** The constant {@code ERROR} of the definition. */
  public static final int ERROR = 2;
  /** The constant {@code STALE} of the definition. */
  public static final int STALE = 3;

  /** Keeps immutable copies of lists. */
  public DiagnosticStatus {
    values = List.copyOf(values);
  }
}
