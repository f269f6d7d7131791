package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * What a parameter may be ({@code rcl_interfaces/ParameterDescriptor}).
 *
 * @param name its name
 * @param type the type of its value
 * @param description for a user to read
 * @param additionalConstraints for a user to read
 * @param readOnly whether it is fixed
 * @param dynamicTyping whether its type may change
 * @param floatingPointRange at most one
 * @param integerRange at most one
 */
@MessageType("rcl_interfaces/ParameterDescriptor")
public record WireDescriptor(String name, int type, String description, String additionalConstraints, boolean readOnly,
    boolean dynamicTyping, List<WireFloatRange> floatingPointRange, List<WireIntRange> integerRange) {

  /** Copies the lists. */
  public WireDescriptor {
    floatingPointRange = List.copyOf(floatingPointRange);
    integerRange = List.copyOf(integerRange);
  }
}
