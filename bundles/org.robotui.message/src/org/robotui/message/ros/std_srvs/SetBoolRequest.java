package org.robotui.message.ros.std_srvs;

import org.robotui.message.MessageType;

/**
 * Switches something on or off ({@code std_srvs/SetBoolRequest}).
 *
 * @param data on or off
 */
@MessageType("std_srvs/SetBoolRequest")
public record SetBoolRequest(boolean data) {}
