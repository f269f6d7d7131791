package org.robotui.api.port;

import org.robotui.data.array.Bytes;

/**
 * How the type of a message is defined, complete: with the definitions of all types that it refers to.
 *
 * @param name what the type is called by those who read such definitions, for example {@code sensor_msgs/msg/LaserScan}
 * @param encoding how the definition is written: {@code ros1msg}, {@code ros2msg}, {@code ros2idl}, {@code protobuf},
 * {@code jsonschema} as the specification of MCAP has them, or another word where there is none
 * @param content the definition; texts in UTF-8
 */
public record RawDefinition(String name, String encoding, Bytes content) {}
