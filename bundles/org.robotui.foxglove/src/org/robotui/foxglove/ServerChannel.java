package org.robotui.foxglove;

/**
 * What a server offers to send.
 *
 * @param id by which the server knows it
 * @param topic its name
 * @param encoding of its messages, such as {@code cdr}, {@code ros1}, {@code json} or {@code protobuf}
 * @param type the name of its schema, such as {@code sensor_msgs/msg/LaserScan}
 * @param schemaEncoding of its schema, such as {@code ros2msg}; may be empty
 * @param schema the schema, in Base64 where its encoding is binary; may be empty
 */
public record ServerChannel(long id, String topic, String encoding, String type, String schemaEncoding,
    String schema) {}
