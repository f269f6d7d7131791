package org.robotui.ros.msgs.std_srvs;

import org.robotui.ros.message.MessageType;

/** Says that the action was done ({@code std_srvs/EmptyResponse}). */
@MessageType("std_srvs/EmptyResponse")
public record EmptyResponse() {}
