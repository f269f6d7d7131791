package org.robotui.message.ros.nav_msgs;

import org.robotui.message.MessageType;

/** Asks for the current map ({@code nav_msgs/GetMapRequest}). */
@MessageType("nav_msgs/GetMapRequest")
public record GetMapRequest() {}
