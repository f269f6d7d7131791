package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageType;

/**
 * A text ({@code std_msgs/String}).
 *
 * @param data the text
 */
@MessageType("std_msgs/String")
public record StdString(String data) {}
