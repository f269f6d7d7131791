package org.robotui.message.ros.std_msgs;

import org.robotui.message.MessageType;

/**
 * A colour ({@code std_msgs/ColorRGBA}).
 *
 * @param r red, 0 to 1
 * @param g green, 0 to 1
 * @param b blue, 0 to 1
 * @param a opacity, 0 to 1
 */
@MessageType("std_msgs/ColorRGBA")
public record ColorRGBA(float r, float g, float b, float a) {}
