package org.robotui.message.ros.std_srvs;

import org.robotui.message.MessageType;

/** Triggers an action ({@code std_srvs/TriggerRequest}). */
@MessageType("std_srvs/TriggerRequest")
public record TriggerRequest() {}
