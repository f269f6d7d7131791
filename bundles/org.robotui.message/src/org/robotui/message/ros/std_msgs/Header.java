package org.robotui.message.ros.std_msgs;

import org.robotui.message.MessageType;

/**
 * When a message was made and in which frame its data are ({@code std_msgs/Header}).
 *
 * @param seq counter of the publisher, starting at any number
 * @param stamp when the data were measured, nanoseconds since the epoch of the sender's clock
 * @param frameId the frame of the data; empty where there is none
 */
@MessageType("std_msgs/Header")
public record Header(long seq, long stamp, String frameId) {}
