package org.robotui.ros;

import java.nio.ByteBuffer;
import org.robotui.message.MessageInfo;

/**
 * How a message came in.
 *
 * @param callerId the publisher's node name
 * @param receiveNanos when the message's last byte was read, by {@link System#nanoTime()}
 * @param raw the message's bytes without a length prefix, read only, little endian, position 0
 * @param peer the type the publisher announced, with the full definition
 * @param latched whether the publisher announced that it latches
 */
public record Reception(String callerId, long receiveNanos, ByteBuffer raw, MessageInfo peer, boolean latched) {}
