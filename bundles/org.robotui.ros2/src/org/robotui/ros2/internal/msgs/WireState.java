package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * A state of a node ({@code lifecycle_msgs/State}).
 *
 * @param id its number
 * @param label its name
 */
@MessageType("lifecycle_msgs/State")
public record WireState(int id, String label) {}
