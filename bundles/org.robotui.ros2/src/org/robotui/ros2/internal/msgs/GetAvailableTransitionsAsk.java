package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * Asks for changes ({@code lifecycle_msgs/GetAvailableTransitionsRequest}).
 *
 */
@MessageType("lifecycle_msgs/GetAvailableTransitionsRequest")
public record GetAvailableTransitionsAsk() {}
