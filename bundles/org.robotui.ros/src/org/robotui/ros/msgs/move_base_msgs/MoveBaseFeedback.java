package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.MessageType;
import org.robotui.ros.msgs.geometry_msgs.PoseStamped;

/**
 * Tells of a drive ({@code move_base_msgs/MoveBaseFeedback}).
 *
 * @param basePosition where the robot is
 */
@MessageType("move_base_msgs/MoveBaseFeedback")
public record MoveBaseFeedback(PoseStamped basePosition) {}
