package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.MessageType;
import org.robotui.ros.msgs.geometry_msgs.PoseStamped;

/**
 * Asks to drive to a place ({@code move_base_msgs/MoveBaseGoal}).
 *
 * @param targetPose the place
 */
@MessageType("move_base_msgs/MoveBaseGoal")
public record MoveBaseGoal(PoseStamped targetPose) {}
