package org.robotui.ros2.internal.msgs;

import java.nio.ByteBuffer;
import java.util.List;
import org.robotui.message.MessageType;

/**
 * The value of a parameter ({@code rcl_interfaces/ParameterValue}).
 *
 * @param type which of the others counts
 * @param boolValue type 1
 * @param integerValue type 2
 * @param doubleValue type 3
 * @param stringValue type 4
 * @param byteArrayValue type 5
 * @param boolArrayValue type 6
 * @param integerArrayValue type 7
 * @param doubleArrayValue type 8
 * @param stringArrayValue type 9
 */
@MessageType("rcl_interfaces/ParameterValue")
public record WireValue(int type, boolean boolValue, long integerValue, double doubleValue, String stringValue,
    ByteBuffer byteArrayValue, ByteBuffer boolArrayValue, long[] integerArrayValue, double[] doubleArrayValue,
    List<String> stringArrayValue) {

  /** Copies the lists. */
  public WireValue {
    stringArrayValue = List.copyOf(stringArrayValue);
  }
}
