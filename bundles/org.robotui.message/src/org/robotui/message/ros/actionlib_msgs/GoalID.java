package org.robotui.message.ros.actionlib_msgs;

import org.robotui.message.MessageType;

/**
 * Names one goal of an action ({@code actionlib_msgs/GoalID}).
 *
 * @param stamp when the goal was sent, nanoseconds since the epoch of the sender's clock
 * @param id unique name
 */
@MessageType("actionlib_msgs/GoalID")
public record GoalID(long stamp, String id) {}
