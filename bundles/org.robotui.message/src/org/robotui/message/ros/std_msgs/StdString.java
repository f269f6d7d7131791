package org.robotui.message.ros.std_msgs;

import org.robotui.message.MessageType;

/**
 * A text ({@code std_msgs/String}).
 *
 * @param data the text
 */
@MessageType("std_msgs/String")
public record StdString(String data) {}
