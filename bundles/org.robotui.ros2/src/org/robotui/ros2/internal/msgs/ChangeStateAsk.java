package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * Asks for a change ({@code lifecycle_msgs/ChangeStateRequest}).
 *
 * @param transition which
 */
@MessageType("lifecycle_msgs/ChangeStateRequest")
public record ChangeStateAsk(WireTransition transition) {}
