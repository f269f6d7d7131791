package org.robotui.ros.msgs.nav_msgs;

import org.robotui.ros.message.MessageType;

/**
 * The current map ({@code nav_msgs/GetMapResponse}).
 *
 * @param map the map
 */
@MessageType("nav_msgs/GetMapResponse")
public record GetMapResponse(OccupancyGrid map) {}
