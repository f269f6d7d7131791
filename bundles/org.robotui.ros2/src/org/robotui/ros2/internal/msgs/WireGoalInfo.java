package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * Which goal ({@code action_msgs/GoalInfo}).
 *
 * @param goalId its identifier
 * @param stamp when it was accepted
 */
@MessageType("action_msgs/GoalInfo")
public record WireGoalInfo(WireUuid goalId, long stamp) {}
