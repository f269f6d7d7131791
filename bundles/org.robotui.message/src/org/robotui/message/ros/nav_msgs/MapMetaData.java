package org.robotui.message.ros.nav_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.Pose;

/**
 * Size and place of a grid map ({@code nav_msgs/MapMetaData}).
 *
 * @param mapLoadTime when the map was loaded, nanoseconds since the epoch of the sender's clock
 * @param resolution side of a cell, metres
 * @param width cells
 * @param height cells
 * @param origin pose of the lower left corner of cell (0, 0) in the map's frame
 */
@MessageType("nav_msgs/MapMetaData")
public record MapMetaData(long mapLoadTime, float resolution, long width, long height, Pose origin) {}
