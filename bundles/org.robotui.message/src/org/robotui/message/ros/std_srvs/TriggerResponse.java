package org.robotui.message.ros.std_srvs;

import org.robotui.message.MessageType;

/**
 * Answers a trigger ({@code std_srvs/TriggerResponse}).
 *
 * @param success whether it was done
 * @param message why not, or what was done
 */
@MessageType("std_srvs/TriggerResponse")
public record TriggerResponse(boolean success, String message) {}
