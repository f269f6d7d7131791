package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A position and an orientation ({@code geometry_msgs/Pose}).
 *
 * @param position the position, metres
 * @param orientation the orientation
 */
@MessageType("geometry_msgs/Pose")
public record Pose(Point position, Quaternion orientation) {}
