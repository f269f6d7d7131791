package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A velocity and how sure it is ({@code geometry_msgs/TwistWithCovariance}).
 *
 * @param twist the velocity
 * @param covariance 6 x 6, row by row: x, y, z, rotations about x, y, z
 */
@MessageType("geometry_msgs/TwistWithCovariance")
public record TwistWithCovariance(Twist twist, double[] covariance) {}
