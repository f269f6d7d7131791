package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * A force and a torque with time and frame ({@code geometry_msgs/WrenchStamped}).
 *
 * @param header time and frame
 * @param wrench the force and the torque
 */
@MessageType("geometry_msgs/WrenchStamped")
public record WrenchStamped(Header header, Wrench wrench) {}
