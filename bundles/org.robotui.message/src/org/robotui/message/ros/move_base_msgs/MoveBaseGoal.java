package org.robotui.message.ros.move_base_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.PoseStamped;

/**
 * Asks to drive to a place ({@code move_base_msgs/MoveBaseGoal}).
 *
 * @param targetPose the place
 */
@MessageType("move_base_msgs/MoveBaseGoal")
public record MoveBaseGoal(PoseStamped targetPose) {}
