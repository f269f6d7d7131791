package org.robotui.message.ros.geometry_msgs;

import org.robotui.message.MessageType;

/**
 * A force and a torque ({@code geometry_msgs/Wrench}).
 *
 * @param force newtons
 * @param torque newton metres
 */
@MessageType("geometry_msgs/Wrench")
public record Wrench(Vector3 force, Vector3 torque) {}
