package org.robotui.message.ros.std_srvs;

import org.robotui.message.MessageType;

/**
 * Answers a switch ({@code std_srvs/SetBoolResponse}).
 *
 * @param success whether it was done
 * @param message why not, or what was done
 */
@MessageType("std_srvs/SetBoolResponse")
public record SetBoolResponse(boolean success, String message) {}
