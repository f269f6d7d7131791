package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;

/**
 * A part of an image ({@code sensor_msgs/RegionOfInterest}).
 *
 * @param xOffset leftmost column
 * @param yOffset topmost row
 * @param height rows
 * @param width columns
 * @param doRectify whether a distinct rectified region is to be computed
 */
@MessageType("sensor_msgs/RegionOfInterest")
public record RegionOfInterest(long xOffset, long yOffset, long height, long width, boolean doRectify) {}
