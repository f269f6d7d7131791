package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * Whether they were set ({@code rcl_interfaces/SetParametersAtomicallyResponse}).
 *
 * @param result whether they were
 */
@MessageType("rcl_interfaces/SetParametersAtomicallyResponse")
public record SetParametersAtomicallyReply(WireSetResult result) {}
