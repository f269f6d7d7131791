package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;

/**
 * One value for each point of a {@link PointCloud} ({@code sensor_msgs/ChannelFloat32}).
 *
 * @param name what the values are, such as {@code intensity}
 * @param values in the order of the points
 */
@MessageType("sensor_msgs/ChannelFloat32")
public record ChannelFloat32(String name, float[] values) {}
