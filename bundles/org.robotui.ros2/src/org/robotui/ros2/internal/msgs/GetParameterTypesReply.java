package org.robotui.ros2.internal.msgs;

import java.nio.ByteBuffer;
import org.robotui.message.MessageType;

/**
 * Types ({@code rcl_interfaces/GetParameterTypesResponse}).
 *
 * @param types in the order of the names
 */
@MessageType("rcl_interfaces/GetParameterTypesResponse")
public record GetParameterTypesReply(ByteBuffer types) {}
