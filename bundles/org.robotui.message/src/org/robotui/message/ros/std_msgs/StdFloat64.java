package org.robotui.message.ros.std_msgs;

import org.robotui.message.MessageType;

/**
 * A number ({@code std_msgs/Float64}).
 *
 * @param data the value
 */
@MessageType("std_msgs/Float64")
public record StdFloat64(double data) {}
