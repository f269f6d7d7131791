package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A pose and how sure it is ({@code geometry_msgs/PoseWithCovariance}).
 *
 * @param pose the pose
 * @param covariance 6 x 6, row by row: x, y, z, rotations about x, y, z
 */
@MessageType("geometry_msgs/PoseWithCovariance")
public record PoseWithCovariance(Pose pose, double[] covariance) {}
