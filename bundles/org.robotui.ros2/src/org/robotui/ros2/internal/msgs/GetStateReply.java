package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * The state ({@code lifecycle_msgs/GetStateResponse}).
 *
 * @param currentState now
 */
@MessageType("lifecycle_msgs/GetStateResponse")
public record GetStateReply(WireState currentState) {}
