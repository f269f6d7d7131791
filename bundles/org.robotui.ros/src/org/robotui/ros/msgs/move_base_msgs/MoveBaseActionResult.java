package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.MessageType;
import org.robotui.ros.msgs.actionlib_msgs.GoalStatus;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Carries a result to the clients ({@code move_base_msgs/MoveBaseActionResult}).
 *
 * @param header time
 * @param status names the goal, and its state
 * @param result the result
 */
@MessageType("move_base_msgs/MoveBaseActionResult")
public record MoveBaseActionResult(Header header, GoalStatus status, MoveBaseResult result) {}
