package org.robotui.ros2.internal.msgs;

import org.robotui.message.MessageType;

/**
 * Whether a parameter was set ({@code rcl_interfaces/SetParametersResult}).
 *
 * @param successful whether it was
 * @param reason why not
 */
@MessageType("rcl_interfaces/SetParametersResult")
public record WireSetResult(boolean successful, String reason) {}
