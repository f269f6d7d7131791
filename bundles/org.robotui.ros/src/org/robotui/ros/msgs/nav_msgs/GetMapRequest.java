package org.robotui.ros.msgs.nav_msgs;

import org.robotui.ros.message.MessageType;

/** Asks for the current map ({@code nav_msgs/GetMapRequest}). */
@MessageType("nav_msgs/GetMapRequest")
public record GetMapRequest() {}
