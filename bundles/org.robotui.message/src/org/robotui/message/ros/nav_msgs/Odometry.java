package org.robotui.message.ros.nav_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.TwistWithCovariance;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Pose and velocity as the robot estimates them ({@code nav_msgs/Odometry}).
 *
 * @param header time and frame of the pose
 * @param childFrameId frame of the velocity
 * @param pose the pose
 * @param twist the velocity
 */
@MessageType("nav_msgs/Odometry")
public record Odometry(Header header, String childFrameId, PoseWithCovariance pose, TwistWithCovariance twist) {}
