package org.robotui.ros2.internal.msgs;

import java.nio.ByteBuffer;
import org.robotui.message.MessageType;

/**
 * An identifier ({@code unique_identifier_msgs/UUID}).
 *
 * @param uuid 16 bytes
 */
@MessageType("unique_identifier_msgs/UUID")
public record WireUuid(ByteBuffer uuid) {}
