package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * A pose with time and frame ({@code geometry_msgs/PoseStamped}).
 *
 * @param header time and frame
 * @param pose the pose
 */
@MessageType("geometry_msgs/PoseStamped")
public record PoseStamped(Header header, Pose pose) {}
