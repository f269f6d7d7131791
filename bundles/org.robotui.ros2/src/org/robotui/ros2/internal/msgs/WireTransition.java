package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * A change of state ({@code lifecycle_msgs/Transition}).
 *
 * @param id its number
 * @param label its name
 */
@MessageType("lifecycle_msgs/Transition")
public record WireTransition(int id, String label) {}
