package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.MessageType;
import org.robotui.ros.msgs.actionlib_msgs.GoalID;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Carries a goal to the server ({@code move_base_msgs/MoveBaseActionGoal}).
 *
 * @param header time
 * @param goalId names the goal
 * @param goal the goal
 */
@MessageType("move_base_msgs/MoveBaseActionGoal")
public record MoveBaseActionGoal(Header header, GoalID goalId, MoveBaseGoal goal) {}
