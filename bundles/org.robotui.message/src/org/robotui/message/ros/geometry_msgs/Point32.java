package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A point in single precision ({@code geometry_msgs/Point32}).
 *
 * @param x metres
 * @param y metres
 * @param z metres
 */
@MessageType("geometry_msgs/Point32")
public record Point32(float x, float y, float z) {}
