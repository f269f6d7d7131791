package org.robotui.message.ros.move_base_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Carries a feedback to the clients ({@code move_base_msgs/MoveBaseActionFeedback}).
 *
 * @param header time
 * @param status names the goal, and its state
 * @param feedback the feedback
 */
@MessageType("move_base_msgs/MoveBaseActionFeedback")
public record MoveBaseActionFeedback(Header header, GoalStatus status, MoveBaseFeedback feedback) {}
