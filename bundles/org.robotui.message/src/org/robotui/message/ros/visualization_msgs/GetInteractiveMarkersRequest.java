package org.robotui.message.ros.visualization_msgs;

import org.robotui.message.MessageType;

/**
 * Asks a server of ROS 2 for all its interactive markers ({@code visualization_msgs/GetInteractiveMarkersRequest}).
 */
@MessageType("visualization_msgs/GetInteractiveMarkersRequest")
public record GetInteractiveMarkersRequest() {}
