package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * Asks for the state ({@code lifecycle_msgs/GetStateRequest}).
 *
 */
@MessageType("lifecycle_msgs/GetStateRequest")
public record GetStateAsk() {}
