package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * What a real number may be ({@code rcl_interfaces/FloatingPointRange}).
 *
 * @param fromValue the least
 * @param toValue the most
 * @param step between two, 0 for any
 */
@MessageType("rcl_interfaces/FloatingPointRange")
public record WireFloatRange(double fromValue, double toValue, double step) {}
