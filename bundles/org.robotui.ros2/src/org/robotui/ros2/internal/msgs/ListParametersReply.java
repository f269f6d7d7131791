package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * Names ({@code rcl_interfaces/ListParametersResponse}).
 *
 * @param result the names
 */
@MessageType("rcl_interfaces/ListParametersResponse")
public record ListParametersReply(WireListResult result) {}
