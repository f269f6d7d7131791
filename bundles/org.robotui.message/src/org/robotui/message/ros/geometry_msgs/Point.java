package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A point ({@code geometry_msgs/Point}).
 *
 * @param x metres
 * @param y metres
 * @param z metres
 */
@MessageType("geometry_msgs/Point")
public record Point(double x, double y, double z) {}
