package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Where a child frame is in its parent frame at a time ({@code geometry_msgs/TransformStamped}).
 *
 * @param header time and parent frame
 * @param childFrameId the child frame
 * @param transform parent from child
 */
@MessageType("geometry_msgs/TransformStamped")
public record TransformStamped(Header header, String childFrameId, Transform transform) {}
