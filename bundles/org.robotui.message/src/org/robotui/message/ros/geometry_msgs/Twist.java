package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A velocity ({@code geometry_msgs/Twist}).
 *
 * @param linear metres per second
 * @param angular radians per second about x, y, z
 */
@MessageType("geometry_msgs/Twist")
public record Twist(Vector3 linear, Vector3 angular) {}
