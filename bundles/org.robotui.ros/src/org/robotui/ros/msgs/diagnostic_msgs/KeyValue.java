package org.robotui.ros.msgs.diagnostic_msgs;

import org.robotui.ros.message.MessageType;

/**
 * A named value ({@code diagnostic_msgs/KeyValue}).
 *
 * @param key the name
 * @param value the value as text
 */
@MessageType("diagnostic_msgs/KeyValue")
public record KeyValue(String key, String value) {}
