package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * How far a goal got ({@code action_msgs/GoalStatus}).
 *
 * @param goalInfo which goal
 * @param status one of seven numbers
 */
@MessageType("action_msgs/GoalStatus")
public record WireGoalStatus(WireGoalInfo goalInfo, int status) {}
