package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * A velocity with time and frame ({@code geometry_msgs/TwistStamped}).
 *
 * @param header time and frame
 * @param twist the velocity
 */
@MessageType("geometry_msgs/TwistStamped")
public record TwistStamped(Header header, Twist twist) {}
