package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A rotation followed by a translation ({@code geometry_msgs/Transform}).
 *
 * @param translation origin of the child frame in the parent frame, metres
 * @param rotation orientation of the child frame in the parent frame
 */
@MessageType("geometry_msgs/Transform")
public record Transform(Vector3 translation, Quaternion rotation) {}
