package org.robotui.message.ros.move_base_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Carries a result to the clients ({@code move_base_msgs/MoveBaseActionResult}).
 *
 * @param header time
 * @param status names the goal, and its state
 * @param result the result
 */
@MessageType("move_base_msgs/MoveBaseActionResult")
public record MoveBaseActionResult(Header header, GoalStatus status, MoveBaseResult result) {}
