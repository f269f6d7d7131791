package org.robotui.message.ros.move_base_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.PoseStamped;

/**
 * Tells of a drive ({@code move_base_msgs/MoveBaseFeedback}).
 *
 * @param basePosition where the robot is
 */
@MessageType("move_base_msgs/MoveBaseFeedback")
public record MoveBaseFeedback(PoseStamped basePosition) {}
