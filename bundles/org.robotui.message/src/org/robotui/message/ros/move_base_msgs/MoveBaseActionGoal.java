package org.robotui.message.ros.move_base_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Carries a goal to the server ({@code move_base_msgs/MoveBaseActionGoal}).
 *
 * @param header time
 * @param goalId names the goal
 * @param goal the goal
 */
@MessageType("move_base_msgs/MoveBaseActionGoal")
public record MoveBaseActionGoal(Header header, GoalID goalId, MoveBaseGoal goal) {}
