package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * A parameter ({@code rcl_interfaces/Parameter}).
 *
 * @param name its name
 * @param value its value
 */
@MessageType("rcl_interfaces/Parameter")
public record WireParameter(String name, WireValue value) {}
