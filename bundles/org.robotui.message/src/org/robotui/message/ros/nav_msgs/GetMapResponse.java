package org.robotui.message.ros.nav_msgs;

import org.robotui.message.MessageType;

/**
 * The current map ({@code nav_msgs/GetMapResponse}).
 *
 * @param map the map
 */
@MessageType("nav_msgs/GetMapResponse")
public record GetMapResponse(OccupancyGrid map) {}
