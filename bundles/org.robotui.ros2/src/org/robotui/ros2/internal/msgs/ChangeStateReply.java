package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * Whether it changed ({@code lifecycle_msgs/ChangeStateResponse}).
 *
 * @param success whether it did
 */
@MessageType("lifecycle_msgs/ChangeStateResponse")
public record ChangeStateReply(boolean success) {}
