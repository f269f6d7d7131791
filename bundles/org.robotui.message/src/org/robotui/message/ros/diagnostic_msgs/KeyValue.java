package org.robotui.message.ros.diagnostic_msgs;

import org.robotui.message.MessageType;

/**
 * A named value ({@code diagnostic_msgs/KeyValue}).
 *
 * @param key the name
 * @param value the value as text
 */
@MessageType("diagnostic_msgs/KeyValue")
public record KeyValue(String key, String value) {}
