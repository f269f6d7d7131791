package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageType;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A velocity with time and frame ({@code geometry_msgs/TwistStamped}).
 *
 * @param header time and frame
 * @param twist the velocity
 */
@MessageType("geometry_msgs/TwistStamped")
public record TwistStamped(Header header, Twist twist) {}
