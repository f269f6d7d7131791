package org.robotui.ros.msgs.std_srvs;

import org.robotui.ros.message.MessageType;

/** Triggers an action ({@code std_srvs/TriggerRequest}). */
@MessageType("std_srvs/TriggerRequest")
public record TriggerRequest() {}
