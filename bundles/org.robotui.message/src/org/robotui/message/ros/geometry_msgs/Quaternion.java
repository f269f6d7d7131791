package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A rotation, of unit length where the sender keeps the rules ({@code geometry_msgs/Quaternion}).
 *
 * @param x imaginary part along x
 * @param y imaginary part along y
 * @param z imaginary part along z
 * @param w real part
 */
@MessageType("geometry_msgs/Quaternion")
public record Quaternion(double x, double y, double z, double w) {}
