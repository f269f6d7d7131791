package org.robotui.recording;

import java.nio.ByteBuffer;

/**
 * A message as it was recorded.
 *
 * @param channel what it belongs to
 * @param logTime when it was recorded, nanoseconds since 1970; recordings are in this order
 * @param publishTime when it was sent, nanoseconds since 1970; the log time where that is not known
 * @param sequence the number that its sender or recorder gave it, 0 to 2^32 - 1; 0 where there is none
 * @param data its bytes, read-only, of its own position; it keeps the chunk that it lies in from being freed, so that
 * who keeps messages for long copies them
 */
public record RecordedMessage(RecordedChannel channel, long logTime, long publishTime, long sequence,
    ByteBuffer data) {}
