package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * What a whole number may be ({@code rcl_interfaces/IntegerRange}).
 *
 * @param fromValue the least
 * @param toValue the most
 * @param step between two, 0 for any
 */
@MessageType("rcl_interfaces/IntegerRange")
public record WireIntRange(long fromValue, long toValue, long step) {}
