package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A vector ({@code geometry_msgs/Vector3}).
 *
 * @param x along x
 * @param y along y
 * @param z along z
 */
@MessageType("geometry_msgs/Vector3")
public record Vector3(double x, double y, double z) {}
