package org.robotui.message.topic;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * A topic whose messages are made of fields by their names.
 *
 * @param encoding makes a message, and throws {@link IllegalArgumentException} where it is not filled in like this; the
 * sentence names the field
 * @param opening offers the topic
 */
public record FieldsTopic(Function<Map<String, Object>, ByteBuffer> encoding,
    Supplier<TopicPublisher<ByteBuffer>> opening) {}
