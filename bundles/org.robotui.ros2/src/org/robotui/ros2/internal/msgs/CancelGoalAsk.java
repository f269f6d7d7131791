package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * Asks to cancel goals ({@code action_msgs/CancelGoalRequest}).
 *
 * @param goalInfo which, by identifier or time
 */
@MessageType("action_msgs/CancelGoalRequest")
public record CancelGoalAsk(WireGoalInfo goalInfo) {}
