package org.robotui.message.ros.rosgraph_msgs;

import org.robotui.message.MessageType;

/**
 * The simulated time ({@code rosgraph_msgs/Clock}).
 *
 * @param clock now, nanoseconds since the epoch of the sender's clock
 */
@MessageType("rosgraph_msgs/Clock")
public record Clock(long clock) {}
