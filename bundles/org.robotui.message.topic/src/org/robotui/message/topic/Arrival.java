package org.robotui.message.topic;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;

/**
 * How a message came.
 *
 * @param sender who published it, as a user knows it
 * @param receiveNanos when its last byte was read, by {@link System#nanoTime()}
 * @param kept whether the publisher keeps its last message for those who come later
 * @param encoding the name of the encoding of its bytes, as in {@link org.robotui.api.port.RawMessage}
 * @param bytes the whole message, read only
 * @param reading reads such bytes as a record of the message's own fields; none where they cannot be read
 */
public record Arrival(String sender, long receiveNanos, boolean kept, String encoding, ByteBuffer bytes,
    Function<Bytes, Optional<DynamicRecord>> reading) {}
